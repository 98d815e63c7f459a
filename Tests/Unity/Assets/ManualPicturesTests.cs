using System.Globalization;
using System.Text.RegularExpressions;
using System.Xml.Linq;
using Nowpose.Prefabs.Pictures;
using NUnit.Framework;

namespace Nowpose.Unity.Tests.Assets;

/// <summary>Tests the drawings of the prefabs for the manual. The tool's option <c>--check</c> compares them with the files.</summary>
public sealed class ManualPicturesTests
{
    static readonly XNamespace Svg = "http://www.w3.org/2000/svg";

    [Test]
    public void AppearancePicture_HeldPose_IsStripedFaintAndHasText()
    {
        var parts = XDocument.Parse(ManualPictures.Appearance(RepositoryFiles.Root)).Root.Elements(Svg + "svg").ToList();

        var opacities = parts.Select(Opacities).ToList();
        Assert.That(parts, Has.Count.EqualTo(3));
        Assert.That(opacities[0], Is.EqualTo(new[] { 1.0 }), "a current pose is drawn in full");
        Assert.That(opacities[1], Is.EqualTo(new[] { 0.4, 1 }), "the ghost is beside the robot");
        Assert.That(opacities[2], Is.EqualTo(new[] { 0.09, 0.6, 1 }).Within(1e-9), "a fade leaves 0.6, a stripe 0.15 of that; the arm is in full");
        Assert.That(parts.Select(part => part.Elements(Svg + "text").SingleOrDefault()?.Value), Is.EqualTo(new[] { null, "uncompensated", "held" }));
    }

    [Test]
    public void CellPicture_WithoutCompensation_DiffersOnlyInGripperAndWorkpiece()
    {
        var parts = XDocument.Parse(ManualPictures.Cell(RepositoryFiles.Root)).Root.Elements(Svg + "svg")
            .Select(part => part.Elements(Svg + "path").Select(path => (Path: path.Attribute("d").Value, Fill: path.Attribute("fill").Value)).ToHashSet())
            .ToList();

        Assert.That(parts, Has.Count.EqualTo(2));
        var common = parts[0].Intersect(parts[1]).Select(face => face.Fill).ToList();
        var differing = parts[0].Except(parts[1]).Select(face => face.Fill).ToList();
        Assert.That(common.Any(IsGrey), "the real arm is the same");
        Assert.That(differing.Any(IsGrey), Is.False);
        Assert.That(differing.Any(IsBlue), "the gripper lags behind the true position");
        Assert.That(differing.Any(fill => !IsBlue(fill)), "the workpiece lags");
    }

    static bool IsGrey(string fill) => fill[1..3] == fill[3..5] && fill[3..5] == fill[5..7];

    static bool IsBlue(string fill) => string.CompareOrdinal(fill[5..7], fill[1..3]) > 0;

    [Test]
    public void Readme_PictureOfTheCell_IsThePictureInTheManual()
    {
        const string picture = RepositoryFiles.Package + "/Documentation~/images/cell.svg";

        var gap = Regex.Match(RepositoryFiles.Read(picture), @"without Nowpose: (\d+ mm behind)").Groups[1].Value;

        Assert.That(RepositoryFiles.Read("README.md"), Does.Match(@$"!\[[^]]+ {gap} [^]]+\]\({picture}\)"));
    }

    static double[] Opacities(XElement part) => [.. part.Elements(Svg + "path")
        .Select(path => double.Parse(path.Attribute("fill-opacity").Value, CultureInfo.InvariantCulture)).Distinct().Order()];

    [Test]
    public void PanelPicture_Drawn_HasAllRowsBelowTheMessage()
    {
        var texts = XDocument.Parse(ManualPictures.Panel(RepositoryFiles.Root)).Root.Elements(Svg + "text").ToList();

        double HeightOf(string words) => double.Parse(
            texts.First(t => t.Value.StartsWith(words, StringComparison.Ordinal)).Attribute("y").Value, CultureInfo.InvariantCulture);
        Assert.That(HeightOf("! joint positions"), Is.LessThan(HeightOf("Pose")));
        Assert.That(HeightOf("Pose"), Is.LessThan(HeightOf("Base")));
        Assert.That(HeightOf("Base"), Is.LessThan(HeightOf("Stay")));
    }

    [Test]
    public void Stripes_InThePictures_MatchTheShader()
    {
        var shader = RepositoryFiles.Under(RepositoryFiles.Package + "/Runtime/Shaders", ".hlsl").Select(RepositoryFiles.Read)
            .SingleOrDefault(text => text.Contains("#define NOWPOSE_STRIPE_METRES", StringComparison.Ordinal));
        Assert.That(shader, Is.Not.Null);

        var metres = Regex.Match(shader, @"#define NOWPOSE_STRIPE_METRES ([\d.]+)").Groups[1].Value;
        Assert.That(HologramLook.StripeMetres, Is.EqualTo(float.Parse(metres, CultureInfo.InvariantCulture)));
        Assert.That(shader, Does.Contain("(metres.x + metres.y + metres.z) * 0.70710678").And.Contain("diagonal / (2 * NOWPOSE_STRIPE_METRES)")
            .And.Contain("(1 - 0.8 * fade) * (1 - 0.85 * hatch * NowposeStripe(metres))"));
    }

    [TestCase("pose-appearance")]
    [TestCase("status-panel")]
    public void Picture_InTheManual_IsOnItsPage(string name)
    {
        Assert.That(RepositoryFiles.Read($"{RepositoryFiles.Package}/Documentation~/{name}.md"), Does.Contain($"](images/{name}.svg)"));
        Assert.That(RepositoryFiles.All, Does.Contain($"{RepositoryFiles.Package}/Documentation~/images/{name}.svg"));
    }
}
