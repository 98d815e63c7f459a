using System.CommandLine;
using Nowpose.Gateway.Options;

namespace Nowpose.Cli.Sync;

/// <summary><c>sync FILE.csv</c>: runs a clock estimator with a log of sync exchanges.</summary>
static class SyncVerb
{
    /// <summary>Maximum number of characters that wait to be printed to a file or a pipe.</summary>
    const int MaxWaiting = 1 << 16;

    public static Command Create()
    {
        var file = new Argument<string>("FILE")
        {
            Description = "Log of exchanges: t1_ns,t2_ns,t3_ns,t4_ns (t1, t4 on C2; t2, t3 on C1), .csv or .csv.gz; "
                + "or a recorded session, .jsonl or .jsonl.gz.",
        };
        var estimator = RuntimeOptions.Estimator();
        var at = TextOption.Create(
            "--at", "File of instants (t_ns on C2, increasing): print the estimate at each of them instead of after each exchange");
        var json = SwitchOption.Create("--json", "Print JSON instead of CSV");
        var page = new Option<string>("--page")
        {
            Description = $"Also write Fig. 8 of the paper for this log as an HTML page (default: {SyncPage.DefaultPath}) and its data as CSV.",
            Arity = ArgumentArity.ZeroOrOne,
            HelpName = "FILE.html",
        };
        var verb = new Command("sync", "Run the clock estimator with a log of sync exchanges.") { file, estimator, at, json, page };
        verb.SetAction((parsed, cancel) =>
            RunAsync(parsed.GetValue(file), parsed.GetValue(estimator), parsed.GetValue(at), parsed.GetValue(json), PageOf(parsed, page), cancel));
        return verb;
    }

    static string PageOf(ParseResult parsed, Option<string> page) =>
        parsed.IsGiven(page) ? parsed.GetValue(page) ?? SyncPage.DefaultPath : null;

    /// <param name="page">Path of the page; null to write none.</param>
    static async Task<int> RunAsync(string file, string estimator, string at, bool json, string page, CancellationToken cancel)
    {
        var (log, instants, lost) = await Invocation.ReadAsync(
            () => (SyncLog.Read(file, out var missing), at == null ? null : SyncLog.ReadInstants(at), missing), cancel);
        var replay = new SyncReplay(estimator);
        var estimates = at == null ? replay.AfterEach(log) : replay.At(instants, log);
        if (page != null)
        {
            SyncPage.Write(page, file, at, LoggedResolution.ExchangesOf(log), estimator);
            await Console.Error.WriteLineAsync(page);
        }
        Print(estimates.TakeWhile(_ => !cancel.IsCancellationRequested), instants?.Count ?? log.Count, at != null, json);
        if (lost > 0) Console.Error.WriteLine(ConsoleMessages.LostLines(file, lost));
        if (replay.Dropped.Values.Sum() == log.Count)
            Console.Error.WriteLine(ConsoleMessages.Line(ExchangeFileMessages.AllDropped(file, log.Count, [.. replay.Dropped.Keys])));
        else foreach (var (fault, count) in replay.Dropped)
            Console.Error.WriteLine(ConsoleMessages.DroppedExchanges(file, count, log.Count, fault));
        if (replay.Steps > 0)
            Console.Error.WriteLine(ConsoleMessages.ClockSteps(file, replay.Steps));
        return ExitStatus.Done;
    }

    // Collects lines, because the console flushes after every line, which would take longer than the estimator. A terminal gets all lines at the end,
    // below the progress bar.
    static void Print(IEnumerable<SyncEstimate> estimates, int count, bool atInstants, bool json)
    {
        var text = new StringWriter { NewLine = "\n" };
        void Flush()
        {
            Console.Out.Write(text);
            text.GetStringBuilder().Clear();
        }
        ConsoleProgress.Run("estimating", "estimates", count, report =>
        {
            var done = 0;
            var counted = estimates.Select(estimate =>
            {
                report(++done);
                if (text.GetStringBuilder().Length > MaxWaiting && Console.IsOutputRedirected) Flush();
                return estimate;
            });
            if (json) SyncOutput.WriteJson(counted, atInstants, text);
            else SyncOutput.WriteCsv(counted, atInstants, text);
        });
        Flush();
    }
}
