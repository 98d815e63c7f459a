using System.CommandLine;
using System.Globalization;
using System.Reflection;
using Nowpose.Benchmarks.Ablation;
using Nowpose.Gateway.Options;
using Nowpose.Kinematics;

namespace Nowpose.Benchmarks.Sensitivity;

/// <summary>sensitivity: measures how the errors change when each constant of the prediction is multiplied by a factor.</summary>
static class SensitivityVerb
{
    /// <summary>Folder of the package's Core, relative to the repository.</summary>
    const string Core = "Packages/com.nowpose.mril/Runtime/Core";

    public static Command Create()
    {
        var (recordings, motions) = (AblationVerb.Recordings(), AblationVerb.Motions());
        var names = new Option<string[]>("--constants")
        {
            Description = "Constants by class or by class and name, such as CandidateGate or CandidateGate.MinScores. Default: all of the prediction",
            HelpName = "NAME", AllowMultipleArgumentsPerToken = true, DefaultValueFactory = _ => [],
        };
        var factors = new Option<double[]>("--factors")
        {
            Description = "Factors of the constants", HelpName = "FACTOR", AllowMultipleArgumentsPerToken = true, DefaultValueFactory = _ => [0.5, 2],
        };
        var command = new Command("sensitivity", "Compare the errors of the default predictor with other values of its constants, in virtual time")
        {
            recordings, motions, names, factors,
        };
        command.SetAction((parsed, stop) =>
        {
            Write((parsed.GetValue(recordings)?.FullName, parsed.GetValue(motions)), parsed.GetValue(names), parsed.GetValue(factors), stop);
            return Task.FromResult(ExitStatus.Done);
        });
        return command;
    }

    static void Write((string Recordings, string Motions) runs, string[] names, double[] factors, CancellationToken stop)
    {
        var folder = Path.GetFullPath("../../../../" + Core, AppContext.BaseDirectory);
        var source = new CoreSource(folder);
        var constants = Selected(source.ConstantsOf(Path.Combine(folder, "Prediction")), names);
        var groups = AblationGroup.All(runs.Recordings, runs.Motions);
        var whole = AblationGroup.Errors(groups);
        var table = new MarkdownTable(Console.Out, ["constant", "value", "factor", .. AblationVerb.Headings(groups)]);
        foreach (var (index, constant) in constants.Index())
        {
            Console.Error.WriteLine($"constant {index + 1} of {constants.Count}: {constant.Name}");
            foreach (var factor in factors)
            {
                stop.ThrowIfCancellationRequested();
                table.Add($"{constant.Name} | {constant.Value:g4} | {factor} | {Cells(source, constant, factor, runs, whole)}");
            }
        }
        Console.WriteLine();
        Console.WriteLine("RMS error divided by that with the present value: geometric mean and (maximum).");
    }

    static IReadOnlyList<SourceConstant> Selected(IReadOnlyList<SourceConstant> all, string[] names)
    {
        var unknown = names.FirstOrDefault(name => !all.Any(one => IsNamed(one, name)));
        if (unknown != null)
            throw new InputException($"--constants: {unknown} is unknown; the classes are {string.Join(", ", all.Select(ClassOf).Distinct())}");
        return names.Length == 0 ? all : [.. all.Where(one => names.Any(name => IsNamed(one, name)))];
    }

    static bool IsNamed(SourceConstant constant, string name) => constant.Name == name || ClassOf(constant) == name;

    static string ClassOf(SourceConstant constant) => constant.Name.Split('.')[0];

    static string Cells(CoreSource source, SourceConstant constant, double factor, (string Recordings, string Motions) runs, double[][] whole)
    {
        try
        {
            var variant = new VariantContext(source.Compile(constant, factor), typeof(RigidTransform).Assembly.GetName().Name);
            var errors = variant.Errors(runs.Recordings, runs.Motions);
            variant.Unload();
            return string.Join(" | ", errors.Zip(whole, (changed, of) => new ErrorRatios(changed, of)));
        }
        catch (Exception failure) when (failure is TargetInvocationException or InvalidOperationException)
        {
            // A number of elements, for example, cannot have every value.
            return "not possible: " + failure.GetBaseException().Message.Split('\n')[0] + string.Concat(Enumerable.Repeat(" |", whole.Length - 1));
        }
    }
}
