using Spectre.Console;

namespace Nowpose.Cli.Recommend;

/// <summary>Progress on stderr: a bar on a terminal, a line every few seconds otherwise.</summary>
static class RecommendProgress
{
    static readonly TimeSpan LineEvery = TimeSpan.FromSeconds(3);

    /// <param name="work">Runs to its end; calls back with how many runs are done.</param>
    public static void Run(int runs, Action<Action<int>> work)
    {
        if (Console.IsErrorRedirected) Lines(runs, work);
        else Bar(runs, work);
    }

    static void Lines(int runs, Action<Action<int>> work)
    {
        var since = System.Diagnostics.Stopwatch.StartNew();
        work(done =>
        {
            if (since.Elapsed < LineEvery) return;
            since.Restart();
            Console.Error.WriteLine($"{done} of {runs} runs");
        });
    }

    static void Bar(int runs, Action<Action<int>> work)
    {
        var console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        console.Progress()
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new RemainingTimeColumn())
            .Start(context =>
            {
                var task = context.AddTask("trying predictors", maxValue: runs);
                work(done => task.Value = done);
            });
    }
}
