using System.Text.RegularExpressions;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Unity.Tests.Manual;

/// <summary>Tests that each field of a component has a tooltip, and that it contains the unit and the correct default.</summary>
public sealed partial class TooltipTests
{
    // Words that a tooltip must contain, by the word in the label of a number or vector that stands for the unit. A port has no unit.
    static readonly Dictionary<string, string> Units = new()
    {
        ["Ms"] = "ms", ["Seconds"] = "seconds", ["Metres"] = "metres", ["Degrees"] = "degrees", ["Port"] = "port",
        ["Megabytes"] = "MB", ["Percent"] = "percent", ["Radians"] = "radians",
        ["Vertices"] = "vertices", ["Steps"] = "steps",
    };

    static IEnumerable<Type> Types => InspectedType.All;

    [TestCaseSource(nameof(Types))]
    public void InspectorField_Tooltip_IsNotEmpty(Type type)
    {
        var without = new InspectedType(type).Fields.Where(f => string.IsNullOrWhiteSpace(f.Tooltip));

        Assert.That(without.Select(f => f.Label), Is.Empty, "add a [Tooltip] to these fields");
    }

    [TestCaseSource(nameof(Types))]
    public void QuantityField_NameAndTooltip_ContainTheUnit(Type type)
    {
        var wrong = new InspectedType(type).Fields.Where(f => IsQuantity(f.Type) && !NamesItsUnit(f.Label, f.Tooltip));

        Assert.That(
            wrong.Select(f => f.Label + ": " + f.Tooltip), Is.Empty,
            $"the name of a number ends with its unit ({string.Join(", ", Units.Keys)}), and the tooltip states it ({string.Join(", ", Units.Values)})");
    }

    [TestCaseSource(nameof(Types))]
    public void Tooltip_StatedDefault_EqualsTheDefaultOfTheField(Type type)
    {
        // Finds, for example, 1.3 in "Distance from the head in metres. Default 1.3: a picture is sharp at an arm's length and more."
        var stated = new InspectedType(type).Fields
            .Select(f => (f.Label, f.Default, Values: Reasons().Matches(f.Tooltip ?? "").Select(m => m.Groups[1].Value).ToList()));

        var wrong = stated.Where(f => f.Values.Count > 0 && !f.Values.Contains(f.Default));

        Assert.That(wrong.Select(f => $"{f.Label}: {string.Join(", ", f.Values)}; the default is {f.Default}"), Is.Empty, "correct the tooltip");
    }

    [TestCase("Glide Seconds", "Seconds in which it glides.", true)]
    [TestCase("Glide Seconds", "How long it glides.", false)]
    [TestCase("Glide Seconds", "Milliseconds in which it glides.", false)]
    [TestCase("Glide", "Seconds in which it glides.", false)]
    [TestCase("Visualisation Ms", "L_visu in ms.", true)]
    [TestCase("Visualisation Ms", "L_visu of displays and forms.", false)]
    [TestCase("Visualisation Ms", null, false)]
    public void NamesItsUnit_LabelAndTooltip_IsTrueOnlyIfBothContainTheUnit(string label, string tooltip, bool expected)
    {
        Assert.That(NamesItsUnit(label, tooltip), Is.EqualTo(expected));
    }

    static bool IsQuantity(Type type) =>
        type == typeof(int) || type == typeof(float) || type == typeof(double) || type == typeof(Vector2) || type == typeof(Vector3);

    static bool NamesItsUnit(string label, string tooltip) => tooltip != null && Word().Matches(label)
        .Any(word => Units.TryGetValue(word.Value, out var unit) && Regex.IsMatch(tooltip, $@"\b{unit}\b", RegexOptions.IgnoreCase));

    [GeneratedRegex(@"(?<=\. Default )(-?\d+(?:\.\d+)?): ")]
    private static partial Regex Reasons();

    [GeneratedRegex(@"\w+")]
    private static partial Regex Word();
}
