// The linter's rules for the page and its tests: what is wrong, unused or compared loosely; names are TypeScript's matter.
import js from "@eslint/js";

const beginning = {                                     // a module begins with a comment, which says what it is
  create: (context) => ({
    Program(node) {
      const comments = context.sourceCode.getAllComments().filter(({ range }) => !node.body.length || range[1] <= node.body[0].range[0]);
      const said = comments.map(({ value }) => value.trim()).join(" ");
      if (!/^[A-Z].*[.:]/s.test(said)) context.report({ node, message: "A module begins with a sentence on what it is." });
    },
  }),
};

export default [
  js.configs.recommended,
  {
    plugins: { page: { rules: { beginning } } },
    rules: {
      "no-undef": "off",
      "no-unused-vars": "error",
      "no-var": "error",
      "prefer-const": ["error", { destructuring: "all" }],
      eqeqeq: "error",
      "page/beginning": "error",
    },
  },
];
