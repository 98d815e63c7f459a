using Nowpose.Session;
using Spectre.Console;

namespace Nowpose.Cli.Demo;

/// <summary>Shows the progress of the run on stderr: as a bar on a terminal, otherwise as a line every few seconds.</summary>
static class DemoProgress
{
    /// <param name="work">The work. It calls its argument with the finished seconds and a status text.</param>
    public static void Run(double seconds, Action<Action<double, Func<string>>> work)
    {
        if (Console.IsErrorRedirected) Lines(seconds, work);
        else Bar(seconds, work);
    }

    /// <summary>Gets the session's status as one line.</summary>
    public static string Describe(CompensationSession session, HeadsetTime now)
    {
        var statistics = session.Statistics(now);
        var latency = statistics.ApplicationLatency is TimeSpan l ? FormattableString.Invariant($", L_app {l.TotalMilliseconds:0} ms") : "";
        return $"clock {statistics.Clock.State.Word()}, pose {PoseStateName.Of(statistics)}{latency}, {statistics.Samples} samples";
    }

    static void Lines(double seconds, Action<Action<double, Func<string>>> work)
    {
        const double every = 3;
        var next = every;
        work((done, words) =>
        {
            if (done < next) return;
            next += every;
            Console.Error.WriteLine(FormattableString.Invariant($"{done:0} of {seconds:0} s: {words()}"));
        });
    }

    static void Bar(double seconds, Action<Action<double, Func<string>>> work)
    {
        var console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Error) });
        console.Progress()
            .Columns(new TaskDescriptionColumn(), new ProgressBarColumn(), new RemainingTimeColumn())
            .Start(context =>
            {
                var task = context.AddTask("connecting", maxValue: seconds);
                var nextWords = 0.0;
                work((done, words) =>
                {
                    task.Value = done;
                    if (done < nextWords) return;
                    nextWords = done + 0.5;
                    task.Description = Markup.Escape(words());
                });
            });
    }
}
