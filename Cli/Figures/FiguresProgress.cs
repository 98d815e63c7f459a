using System.Diagnostics;
using Spectre.Console;

namespace Nowpose.Cli.Figures;

/// <summary>Shows on stderr how much work is finished: as a bar on a terminal, otherwise as a line every few seconds.</summary>
static class FiguresProgress
{
    /// <param name="total">Total number of work items.</param>
    /// <param name="work">The work. It calls its argument with the number of finished items, from any thread.</param>
    public static T Run<T>(int total, Func<Action<int>, T> work) => Console.IsErrorRedirected ? Lines(total, work) : Bar(total, work);

    static T Lines<T>(int total, Func<Action<int>, T> work)
    {
        const double every = 3;
        var errors = Console.Error;
        var clock = Stopwatch.StartNew();
        var (gate, next) = (new Lock(), every);
        return work(done =>
        {
            lock (gate)
            {
                if (clock.Elapsed.TotalSeconds < next && done < total) return;
                next = clock.Elapsed.TotalSeconds + every;
                errors.WriteLine(FormattableString.Invariant($"figures: {done} of {total} studies, {clock.Elapsed.TotalSeconds:0} s"));
            }
        });
    }

    static T Bar<T>(int total, Func<Action<int>, T> work)
    {
        var console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        return console.Progress()
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new PercentageColumn(), new RemainingTimeColumn())
            .Start(context =>
            {
                var task = context.AddTask("computing", maxValue: total);
                return work(done => task.Value = Math.Max(task.Value, done));
            });
    }
}
