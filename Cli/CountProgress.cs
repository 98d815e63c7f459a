using System.Diagnostics;
using Nowpose.Cli.Messages;
using Spectre.Console;

namespace Nowpose.Cli;

/// <summary>Shows on stderr how many items are finished: as a bar on a terminal, otherwise as a line every few seconds.</summary>
static class CountProgress
{
    static readonly TimeSpan LineEvery = TimeSpan.FromSeconds(3);

    /// <param name="what">Label of the bar.</param>
    /// <param name="units">Name of the counted items, for example "pictures".</param>
    /// <param name="total">Total number of items, or null if it is unknown.</param>
    /// <param name="work">The work. It calls its argument with the number of finished items.</param>
    public static void Run(string what, string units, int? total, Action<Action<int>> work)
    {
        if (Console.IsErrorRedirected) Lines(units, total, work);
        else Bar(what, total, work);
    }

    static void Lines(string units, int? total, Action<Action<int>> work)
    {
        var since = Stopwatch.StartNew();
        work(done =>
        {
            if (since.Elapsed < LineEvery) return;
            since.Restart();
            Console.Error.WriteLine(ConsoleMessages.Progress(done, total, units));
        });
    }

    static void Bar(string what, int? total, Action<Action<int>> work)
    {
        var console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        console.Progress()
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new RemainingTimeColumn())
            .Start(context =>
            {
                var task = context.AddTask(what, maxValue: total ?? 1);
                task.IsIndeterminate = total == null;
                work(done => task.Value = done);
            });
    }
}
