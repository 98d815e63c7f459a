using System.CommandLine;
using System.Numerics;
using MathNet.Numerics.Statistics;
using Nowpose.Benchmarks.Comparison;
using Nowpose.Gateway.Options;
using Nowpose.Prediction;

namespace Nowpose.Benchmarks.Ablation;

/// <summary>ablation: measures how the error changes when each part of the default predictor is removed.</summary>
static class AblationVerb
{
    static readonly PredictionParts[] Parts = [.. Enum.GetValues<PredictionParts>().Where(part => BitOperations.IsPow2((int)part))];

    public static Command Create()
    {
        var (recordings, motions) = (Recordings(), Motions());
        var heldOut = NumberOption.CreateOptional("--held-out",
            "Number of sets of three seeds with which nothing was selected. Only the errors of the whole predictor are then computed", 2, 100, "");
        var command = new Command("ablation", "Compare the errors of the default predictor with and without each of its parts, in virtual time")
        {
            recordings, motions, heldOut,
        };
        command.Validators.Add(result =>
        {
            if (result.GetResult(heldOut) == null) return;
            foreach (var other in new Option[] { recordings, motions }.Where(other => result.GetResult(other) != null))
                result.AddError($"{other.Name}: --held-out uses all simulated motions, and no others; remove one of the two options.");
        });
        command.SetAction((parsed, stop) =>
        {
            if (parsed.GetValue(heldOut) is int sets) WriteHeldOut(sets, stop);
            else Write(AblationGroup.All(parsed.GetValue(recordings)?.FullName, parsed.GetValue(motions)), stop);
            return Task.FromResult(ExitStatus.Done);
        });
        return command;
    }

    /// <summary>Creates the option for the folder with recorded motions.</summary>
    public static Option<DirectoryInfo> Recordings() => new Option<DirectoryInfo>("--recordings")
    {
        Description = "Folder with motions in the format of replay (*.csv, *.csv.gz). Default: simulated motions only", HelpName = "DIR",
    }.AcceptExistingOnly();

    /// <summary>Creates the option that selects some of the motions.</summary>
    public static Option<string> Motions() => TextOption.Create("--motions", "Only the motions whose names in the table contain this text", "TEXT");

    /// <summary>Returns the headings of the columns of all groups.</summary>
    public static IEnumerable<string> Headings(IReadOnlyList<AblationGroup> groups) =>
        groups.Select(group => $"{group.Name} ({group.Names.Count} errors)");

    static void Write(IReadOnlyList<AblationGroup> groups, CancellationToken stop)
    {
        var whole = AblationGroup.Errors(groups);
        var table = new MarkdownTable(Console.Out, ["without", .. Headings(groups)]);
        foreach (var part in Parts)
        {
            stop.ThrowIfCancellationRequested();
            table.AddCells([$"{part}", .. groups.Select((group, i) => new ErrorRatios(group.Errors(Predictors.Default, part), whole[i]).ToString())]);
        }

        Console.WriteLine();
        Console.WriteLine("RMS error divided by that of the whole predictor: geometric mean and (maximum).");
        for (var i = 0; i < groups.Count; i++) WriteRuns(groups[i], whole[i]);
    }

    static void WriteHeldOut(int sets, CancellationToken stop)
    {
        AblationGroup[] groups = [.. AblationGroup.HeldOut(sets)];
        var ratios = new List<double[]>();
        foreach (var group in groups)
        {
            stop.ThrowIfCancellationRequested();
            ratios.Add([.. group.Errors(Predictors.Default).Zip(group.MinFixedErrors(), (error, of) => error / of)]);
        }
        var table = new MarkdownTable(Console.Out, "held-out seeds", "adaptive ÷ best fixed, mean ± standard deviation of the sets");
        var names = groups[0].Names;
        for (var i = 0; i < names.Count; i++) table.Add($"{names[i]} | {MeanAndDeviation(ratios.Select(set => set[i]))}");
        table.Add($"mean | {MeanAndDeviation(ratios.Select(set => set.Average()))}");
    }

    static string MeanAndDeviation(IEnumerable<double> values)
    {
        var (mean, deviation) = values.MeanStandardDeviation();
        return FormattableString.Invariant($"{mean:0.00} ± {deviation:0.00}");
    }

    static void WriteRuns(AblationGroup group, double[] whole)
    {
        var (hold, quadratic, best) = (group.Errors("hold"), group.Errors("quadratic"), group.MinFixedErrors());
        Console.WriteLine();
        var table = new MarkdownTable(Console.Out, group.Name, "quadratic ÷ hold", "adaptive ÷ quadratic", "adaptive ÷ best fixed");
        for (var i = 0; i < whole.Length; i++)
            table.Add($"{group.Names[i]} | {quadratic[i] / hold[i]:0.00} | {whole[i] / quadratic[i]:0.00} | {whole[i] / best[i]:0.00}");
        var overQuadratic = Means.Geometric(whole.Zip(quadratic, (error, of) => error / of));
        var overBest = whole.Zip(best, (error, least) => error / least).Average();
        table.Add($"mean; of adaptive ÷ quadratic the geometric one | | {overQuadratic:0.0000} | {overBest:0.0000}");
    }
}
