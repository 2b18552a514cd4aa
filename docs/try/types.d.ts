// What scripts of others give to the page, as TypeScript has to know it.
declare var katex: undefined | {
  render(latex: string, place: HTMLElement, options: Record<string, unknown>): void;
};
