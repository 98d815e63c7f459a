using System.CommandLine;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.Options;
using Nowpose.Sync;

namespace Nowpose.Cli.Sync;

/// <c>sync FILE.csv</c>: runs the clock estimator over a log of sync exchanges.
static class SyncVerb
{
    public static Command Create()
    {
        var file = new Argument<string>("FILE")
        {
            Description = "Log of exchanges: t1_ns,t2_ns,t3_ns,t4_ns (t1, t4 on C2; t2, t3 on C1), .csv or .csv.gz; "
                + "or a recorded session, .jsonl or .jsonl.gz.",
        };
        var estimator = RuntimeOptions.Estimator();
        var at = new Option<string>("--at")
        {
            Description = "File of instants (t_ns on C2, increasing): print the estimate at each of them instead of after each exchange.",
        };
        var json = new Option<bool>("--json") { Description = "Print JSON instead of CSV." };
        var page = new Option<string>("--page")
        {
            Description = $"Also write Fig. 8 of the paper for this log as a page, {SyncPage.DefaultPath} unless named here, and its data as CSV.",
            Arity = ArgumentArity.ZeroOrOne,
            HelpName = "FILE.html",
        };
        var verb = new Command("sync", "Run the clock estimator with a log of sync exchanges.") { file, estimator, at, json, page };
        // On a separate thread, so that Ctrl-C finds the action started and can wait for its partial result.
        verb.SetAction((parsed, cancel) => Task.Run(
            () => Run(parsed.GetValue(file), parsed.GetValue(estimator), parsed.GetValue(at), parsed.GetValue(json), PageOf(parsed, page), cancel),
            CancellationToken.None));
        return verb;
    }

    static string PageOf(ParseResult parsed, Option<string> page) =>
        parsed.GetResult(page) is { Implicit: false } ? parsed.GetValue(page) ?? SyncPage.DefaultPath : null;

    /// <param name="page">Path of the page; null for none.</param>
    static int Run(string file, string estimator, string at, bool json, string page, CancellationToken cancel)
    {
        var log = SyncLog.Read(file);
        var replay = new SyncReplay(ClockEstimators.Create(estimator));
        var beliefs = at == null ? replay.AfterEach(log) : replay.At(SyncLog.ReadInstants(at), log);
        if (page != null)
        {
            SyncPage.Write(page, file, [.. log.Select(each => each.Exchange)], estimator);
            Console.Error.WriteLine(page);
        }
        Print(beliefs.TakeWhile(_ => !cancel.IsCancellationRequested), at != null, json);
        foreach (var (fault, count) in replay.Dropped)
            Console.Error.WriteLine(ConsoleMessages.DroppedExchanges(file, count, log.Count, fault));
        if (replay.Steps > 0)
            Console.Error.WriteLine(ConsoleMessages.ClockSteps(file, replay.Steps));
        return cancel.IsCancellationRequested ? ExitStatus.Interrupted : ExitStatus.Done;
    }

    // Collected first: the console flushes after every line, which takes longer than the estimator.
    static void Print(IEnumerable<SyncBelief> beliefs, bool atInstants, bool json)
    {
        var text = new StringWriter { NewLine = "\n" };
        if (json) SyncOutput.WriteJson(beliefs, atInstants, text);
        else SyncOutput.WriteCsv(beliefs, atInstants, text);
        Console.Out.Write(text);
    }
}
