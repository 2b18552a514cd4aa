"""gyrostat decide --batch: a decision for each line of a file, in order.

`batch` is the verb, `batch_lines` reads the lines as they come and keeps the answers, `batch_worker` is a
process that answers within a time; where it takes longer, another one takes the next line. `batch_team` deals
the lines to several of them.
"""
