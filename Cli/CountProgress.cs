using System.Diagnostics;
using Spectre.Console;

namespace Nowpose.Cli;

/// <summary>Progress on stderr of work that is counted: a bar on a terminal, a line every few seconds otherwise.</summary>
static class CountProgress
{
    static readonly TimeSpan LineEvery = TimeSpan.FromSeconds(3);

    /// <param name="what">What the bar is named.</param>
    /// <param name="units">What is counted: "pictures".</param>
    /// <param name="total">How many there are; null when nobody knows yet.</param>
    /// <param name="work">Runs to its end; calls back with how many are done.</param>
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
            Console.Error.WriteLine(total is int all ? $"{done} of {all} {units}" : $"{done} {units}");
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
