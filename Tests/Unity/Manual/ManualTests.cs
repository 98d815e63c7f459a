using System.Globalization;
using System.Text.RegularExpressions;
using Nowpose.Unity.Rendering;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Manual;

/// <summary>Tests that the manual's pages describe the fields and members that the components have.</summary>
public sealed partial class ManualTests
{
    const string Index = "index.md";

    /// <summary>Units on the pages, by the word that stands for the unit in the label of a field.</summary>
    static readonly Dictionary<string, string> Units = new()
    {
        ["Ms"] = "ms", ["Seconds"] = "s", ["Metres"] = "m", ["Degrees"] = "degrees", ["Megabytes"] = "MB", ["Percent"] = "%", ["Radians"] = "rad",
    };

    static IEnumerable<Type> Types => InspectedType.All;

    [TestCaseSource(nameof(Types))]
    public void Type_InThePackage_HasAMenuEntryAndAPage(Type type)
    {
        var inspected = new InspectedType(type);

        Assert.That(inspected.Title, Is.Not.Null, "add [AddComponentMenu(\"Nowpose/TITLE\")], or [CreateAssetMenu] for an asset");
        Assert.That(
            ManualPage.Exists(inspected.PageName),
            $"add the page Documentation~/{inspected.PageName} with this title, the tables Fields and For scripts, and a link in {Index}");
        Assert.That(ManualPage.Read(inspected.PageName).Title, Is.EqualTo(inspected.Title).IgnoreCase);
    }

    [TestCaseSource(nameof(Types))]
    public void Page_Fields_MatchTheInspectorInOrder(Type type)
    {
        var inspected = new InspectedType(type);

        var rows = ManualPage.Read(inspected.PageName).TableUnder("Fields");

        Assert.That(
            rows.Select(r => r[0]), Is.EqualTo(inspected.Fields.Select(f => f.Label)),
            $"the table Fields of {inspected.PageName} needs one row for each field, in the order of the Inspector");
    }

    [TestCaseSource(nameof(Types))]
    public void Page_Defaults_MatchANewComponent(Type type)
    {
        var inspected = new InspectedType(type);
        var rows = ManualPage.Read(inspected.PageName).TableUnder("Fields").ToDictionary(r => r[0]);

        // On the page, a unit may follow the default.
        var wrong = inspected.Fields.Where(f => !(rows[f.Label][1] + " ").StartsWith(f.Default + " ", StringComparison.Ordinal));

        Assert.That(wrong.Select(f => f.Label + ": " + rows[f.Label][1] + " is " + f.Default), Is.Empty, "correct the defaults on " + inspected.PageName);
    }

    [TestCaseSource(nameof(Types))]
    public void Page_Ranges_MatchTheSliders(Type type)
    {
        var inspected = new InspectedType(type);
        var rows = ManualPage.Read(inspected.PageName).TableUnder("Fields").ToDictionary(r => r[0]);

        foreach (var field in inspected.Fields.Where(f => f.Range != null))
            Assert.That(
                rows[field.Label][2], Does.StartWith(string.Format(CultureInfo.InvariantCulture, "{0} to {1}", field.Range.min, field.Range.max)),
                field.Label);
    }

    [TestCaseSource(nameof(Types))]
    public void Page_Units_MatchTheLabels(Type type)
    {
        var inspected = new InspectedType(type);
        var rows = ManualPage.Read(inspected.PageName).TableUnder("Fields").ToDictionary(r => r[0]);

        var wrong = inspected.Fields.Where(f => UnitOf(f.Label) is { } unit && !rows[f.Label].Skip(1).Take(2).All(cell => HasUnit(cell, unit)));

        Assert.That(
            wrong.Select(f => string.Join(" | ", rows[f.Label].Take(3))), Is.Empty,
            $"on {inspected.PageName}, the default and the range of these fields need the unit");
    }

    [TestCaseSource(nameof(Types))]
    public void Page_EveryField_HasADescription(Type type)
    {
        var rows = ManualPage.Read(new InspectedType(type).PageName).TableUnder("Fields");

        Assert.That(
            rows.Where(r => r.Length != 4 || r.Any(c => c.Length == 0)).Select(r => string.Join(" | ", r)), Is.Empty,
            "each row has a label, a default, the allowed values and a description");
    }

    [TestCaseSource(nameof(Types))]
    public void Page_Members_MatchTheClass(Type type)
    {
        var inspected = new InspectedType(type);

        var rows = ManualPage.Read(inspected.PageName).TableUnder("For scripts");

        Assert.That(
            rows.Select(r => Member().Match(r[0]).Groups[1].Value), Is.EquivalentTo(inspected.Members),
            $"the table For scripts of {inspected.PageName} needs one row for each public member");
    }

    [Test]
    public void Types_AssembliesWithComponents_AreComplete()
    {
        var withComponents = RepositoryFiles.Under(RepositoryFiles.Package + "/Runtime", ".asmdef")
            .Where(file => RepositoryFiles.Under(file[..file.LastIndexOf('/')], ".cs").Any(f => RepositoryFiles.Read(f).Contains("[AddComponentMenu(")))
            .Select(file => Path.GetFileNameWithoutExtension(file));

        Assert.That(
            withComponents, Is.SubsetOf(Types.Select(type => type.Assembly.GetName().Name)),
            $"add the components of the new assembly to {nameof(InspectedType)}.{nameof(InspectedType.All)}");
    }

    [Test]
    public void Index_Links_ReachEveryPage()
    {
        var pages = ManualPage.Names.Where(n => n != Index);

        Assert.That(ManualPage.Read(Index).Linked, Is.SupersetOf(pages), $"{Index} needs a link to each page");
    }

    [TestCase("40 ms", "ms", true)]
    [TestCase("(0.00, 0.00, 0.00) m", "m", true)]
    [TestCase("0, or 0.01 to 100 rad/s²", "rad", true)]
    [TestCase("finite", "m", true)]
    [TestCase("40", "ms", false)]
    [TestCase("40 ms", "m", false)]
    public void Unit_TableCell_FollowsTheNumber(string cell, string unit, bool expected)
    {
        Assert.That(HasUnit(cell, unit), Is.EqualTo(expected));
    }

    [TestCase("_visualisationMs", "Visualisation Ms")]
    [TestCase("_webSocketPort", "Web Socket Port")]
    [TestCase("m_URDFText", "URDF Text")]
    [TestCase("GpuCompletion", "Gpu Completion")]
    [TestCase("joint", "Joint")]
    public void Label_Name_EqualsUnitysLabel(string name, string label)
    {
        Assert.That(InspectedType.Label(name), Is.EqualTo(label));
    }

    static string UnitOf(string label) => label.Split(' ').Select(word => Units.GetValueOrDefault(word)).FirstOrDefault(unit => unit != null);

    // Returns whether the unit follows a number of the cell; true for a cell without digits. Not every number needs the unit: "0.005 to 5 m, or 0".
    static bool HasUnit(string cell, string unit) => !cell.Any(char.IsDigit) || Regex.IsMatch(cell, $@"\d\)? {Regex.Escape(unit)}(?!\w)");

    /// <summary>Matches the name in `event Shown`, `Connect()` or `Settings {get; set;}`.</summary>
    [GeneratedRegex(@"^`(?:event |static |const )*(\w+)")]
    private static partial Regex Member();
}
