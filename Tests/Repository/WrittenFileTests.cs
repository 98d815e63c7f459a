using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Repository;

/// <summary>Checks that the programs write their files through the one class that leaves no incomplete file.</summary>
public sealed partial class WrittenFileTests
{
    static readonly string[] Programs = ["Gateway/", "Cli/"];

    /// <summary>Files that open other files for writing, with the reason.</summary>
    static readonly string[] Exceptions =
    [
        // The class itself.
        "Gateway/OutputFile.cs",
        // Recordings, which grow during a run.
        "Gateway/Recording/LineFile.cs",
        "Cli/OptionPath.cs",
        // Opens files of an earlier calibration and writes nothing.
        "Cli/Calibrate/CalibrationOutput.cs",
        // The lock of the folder, and the standard output, which are not results on the disk.
        "Cli/Demo/DemoOutput.cs",
        "Gateway/Options/GuardedConsole.cs",
        // Copies to a folder that it then renames.
        "Cli/Unity/SampleCopy.cs",
    ];

    [Test]
    public void Programs_WriteFiles_OnlyAsAWhole()
    {
        var writing = RepositoryFiles.All
            .Where(file => file.EndsWith(".cs", StringComparison.Ordinal) && Programs.Any(program => file.StartsWith(program, StringComparison.Ordinal)))
            .Where(file => Writing().IsMatch(RepositoryFiles.Read(file)));

        Assert.That(writing, Is.EquivalentTo(Exceptions), "use OutputFile");
    }

    [GeneratedRegex(@"\bFile\.(?:Write|Append|Create|Open(?!Read)|Copy|Replace)|\bFileAccess\.(?:Read)?Write\b|\bnew StreamWriter\((?!file, leaveOpen)")]
    private static partial Regex Writing();
}
