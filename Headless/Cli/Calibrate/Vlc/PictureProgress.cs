using Spectre.Console;

namespace Nowpose.Cli.Calibrate.Vlc;

/// <summary>Progress on stderr: a bar on a terminal, a line every few seconds otherwise.</summary>
static class PictureProgress
{
    static readonly TimeSpan LineEvery = TimeSpan.FromSeconds(3);

    /// <param name="pictures">How many there are; null when nobody knows yet.</param>
    /// <param name="work">Runs to its end; calls back with how many pictures are done.</param>
    public static void Run(string what, int? pictures, Action<Action<int>> work)
    {
        if (Console.IsErrorRedirected) Lines(pictures, work);
        else Bar(what, pictures, work);
    }

    static void Lines(int? pictures, Action<Action<int>> work)
    {
        var since = System.Diagnostics.Stopwatch.StartNew();
        work(done =>
        {
            if (since.Elapsed < LineEvery) return;
            since.Restart();
            Console.Error.WriteLine(pictures is int all ? $"{done} of {all} pictures" : $"{done} pictures");
        });
    }

    static void Bar(string what, int? pictures, Action<Action<int>> work)
    {
        var console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        console.Progress()
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new RemainingTimeColumn())
            .Start(context =>
            {
                var task = context.AddTask(what, maxValue: pictures ?? 1);
                task.IsIndeterminate = pictures == null;
                work(done => task.Value = done);
            });
    }
}
