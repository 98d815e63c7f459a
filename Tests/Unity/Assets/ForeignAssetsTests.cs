using System.Globalization;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>Tests the stand-ins for prefabs of other packages, which are edited by hand.</summary>
public sealed partial class ForeignAssetsTests
{
    const string Folder = "Headless/StandIn/ForeignAssets/MixedReality.Toolkit/";

    /// <summary>FileID of the button's instance in MRTK3's variant Action Button Checkbox.</summary>
    const long ButtonInstance = 2843419059293016730;

    /// <summary>Unity derives the fileIDs of a variant's objects in this way. Others would be wrong in a project with the real MRTK3.</summary>
    [Test]
    public void ActionButtonCheckbox_FileIds_AreDerivedFromThoseOfTheButton()
    {
        var derived = FileIds("Action Button.prefab").Select(id => (id ^ ButtonInstance) & long.MaxValue);

        Assert.That(FileIds("Action Button Checkbox.prefab"), Is.EquivalentTo(derived));
    }

    static List<long> FileIds(string prefab) =>
        [.. Header().Matches(RepositoryFiles.Read(Folder + prefab)).Select(header => long.Parse(header.Groups[1].Value, CultureInfo.InvariantCulture))];

    [GeneratedRegex(@"^--- !u!\d+ &(-?\d+)", RegexOptions.Multiline)]
    private static partial Regex Header();
}
