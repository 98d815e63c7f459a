using System.Diagnostics;
using Nowpose.Session;
using Spectre.Console;

namespace Nowpose.Cli;

/// <summary>Shows the progress of a run on stderr: as a bar on a terminal, otherwise as a line every few seconds.</summary>
static class ConsoleProgress
{
    static readonly TimeSpan LineEvery = TimeSpan.FromSeconds(3), LabelEvery = TimeSpan.FromSeconds(0.5);

    /// <summary>Receives the finished part of the work, from any thread.</summary>
    /// <param name="line">Creates a line for an output without a bar.</param>
    /// <param name="label">Creates a new label of the bar; null if the label does not change.</param>
    delegate void Report(double done, Func<string> line, Func<string> label = null);

    /// <param name="what">Label of the bar.</param>
    /// <param name="units">Name of the counted items, for example "pictures".</param>
    /// <param name="total">Total number of items, or null if it is unknown.</param>
    /// <param name="work">The work. It calls its argument with the number of finished items.</param>
    public static void Run(string what, string units, int? total, Action<Action<int>> work) => Run(
        what, total, report => work(done => report(done, () => ConsoleMessages.Progress(done, total, units))));

    /// <summary>Shows the progress of a session.</summary>
    /// <param name="work">The work. It calls its argument with the finished seconds and a status text.</param>
    public static void Run(double seconds, Action<Action<double, Func<string>>> work) => Run(
        "connecting", seconds,
        report => work((done, words) => report(done, () => FormattableString.Invariant($"{done:0} of {seconds:0} s: {words()}"), words)));

    /// <summary>Gets the session's status as one line.</summary>
    public static string Describe(CompensationSession session, HeadsetTime now)
    {
        var statistics = session.Statistics(now);
        var latency = statistics.ApplicationLatency is TimeSpan l ? FormattableString.Invariant($", L_app {l.TotalMilliseconds:0} ms") : "";
        return $"clock {statistics.Clock.State.Word()}, pose {PoseStateName.Of(statistics)}{latency}, {statistics.Samples} samples";
    }

    static void Run(string what, double? total, Action<Report> work)
    {
        if (Console.IsErrorRedirected) Lines(work);
        else Bar(what, total, work);
    }

    static void Lines(Action<Report> work)
    {
        var (gate, since) = (new Lock(), Stopwatch.StartNew());
        var errors = Console.Error;
        work((_, line, _) =>
        {
            lock (gate)
            {
                if (since.Elapsed < LineEvery) return;
                since.Restart();
                errors.WriteLine(line());
            }
        });
    }

    static void Bar(string what, double? total, Action<Report> work)
    {
        var console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        console.Progress()
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new RemainingTimeColumn())
            .Start(context =>
            {
                var task = context.AddTask(what, maxValue: total ?? 1);
                task.IsIndeterminate = total == null;
                var since = Stopwatch.StartNew();
                work((done, _, label) =>
                {
                    task.Value = Math.Max(task.Value, done);
                    if (label == null || since.Elapsed < LabelEvery) return;
                    since.Restart();
                    task.Description = Markup.Escape(label());
                });
            });
    }
}
