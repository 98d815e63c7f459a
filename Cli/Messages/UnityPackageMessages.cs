namespace Nowpose.Cli.Messages;

/// <summary>Error messages of the command <c>unity</c> about the package and its samples, with remedies.</summary>
static class UnityPackageMessages
{
    public static string NotAnAddress(string text, string package) =>
        $"--package: '{text}' is neither a Git URL nor a folder or tarball with the package {package}; pass one of these";

    public const string Owner = "--package: replace OWNER with the name of the account that has your copy of the repository";
    public const string ObjectExpected = "a JSON object is expected";

    public static string NotJson(string file, long? line) => FormattableString.Invariant($"{file}:{line}: not a JSON object; correct the line");

    public const string SamplesNotAnArray = "samples must be an array";

    public static string NotAnObject(string place) => $"{place} must be an object";
    public static string NotAString(string place, string name) => $"{place}{name} must be a string";

    public const string FilesMissing = "the files of the package are not next to this program; publish the program again, or run it from a clone";

    public static string UnknownSample(string name, string allowed) => $"--sample: '{name}' is not a sample of the package; allowed: {allowed}";
    public static string SampleMissing(string sample, string folder) =>
        $"--sample: the files of '{sample}' are missing: {folder}; install the package again";

    public static string FileInTheWay(string folder) =>
        $"{folder}: is a file where the sample needs a folder; rename or delete it, and try again";

    public static string SampleChanged(string file, int more) =>
        $"{file}: differs from the sample's file{(more == 0 ? "" : FormattableString.Invariant($" ({more} more)"))}; "
        + "move or delete the folder of the sample, and try again";

    public static string OtherVersion(string folder, string sample) =>
        $"{folder}: is the sample '{sample}' of another version; a project can contain only one copy. Delete this folder and its .meta file "
        + "(save your changes first), and try again";

    public static string NotCopied(string folder, string sample, string reason) =>
        $"{folder}: the sample '{sample}' cannot be copied: {reason}; the manifest is not changed; remove the cause, and try again";
}
