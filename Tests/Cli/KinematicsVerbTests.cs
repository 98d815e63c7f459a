using System.Text.Json;
using Nowpose.Cli.Messages;
using Nowpose.Gateway.Messages;
using Nowpose.Messages;
using NUnit.Framework;

namespace Nowpose.Headless.Tests.Cli;

public class KinematicsVerbTests
{
    const string Slide = """
        <robot name="slide"><link name="base"/><link name="a"/><link name="b"/><link name="plate"/>
        <joint name="lead" type="prismatic"><parent link="base"/><child link="a"/><limit lower="0" upper="0.5"/></joint>
        <joint name="follow" type="prismatic"><parent link="base"/><child link="b"/><limit lower="-1" upper="0.8"/>
        <mimic joint="lead" multiplier="2" offset="0.1"/></joint>
        <joint name="mount" type="fixed"><parent link="base"/><child link="plate"/><axis xyz="0 0 0"/></joint></robot>
        """;

    static async Task<CliRun> RunAsync(params string[] options)
    {
        using var file = new TemporaryFile(Slide, ".urdf");
        return await CliRun.OfAsync(["kinematics", file.Path, .. options]);
    }

    static double X(CliRun run, string link) =>
        JsonDocument.Parse(run.Output).RootElement.GetProperty("links").GetProperty(link)[3].GetDouble();

    [Test]
    public async Task Kinematics_JsonOption_PrintsRootAndRowMajorMatrices()
    {
        var run = await RunAsync("--joints", "lead=0.1", "--json");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Errors, Is.Empty);
        var result = JsonDocument.Parse(run.Output).RootElement;
        Assert.That(result.GetProperty("root").GetString(), Is.EqualTo("base"));
        Assert.That(result.GetProperty("links").EnumerateObject().Select(link => link.Name), Is.EquivalentTo(new[] { "base", "a", "b", "plate" }));
        Assert.That(
            result.GetProperty("links").GetProperty("a").EnumerateArray().Select(v => v.GetDouble()),
            Is.EqualTo(new[] { 1, 0, 0, 0.1, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }));
    }

    [Test]
    public async Task Kinematics_JsonOption_PrintsAsciiOnly()
    {
        using var file = new TemporaryFile("<robot name=\"r\"><link name=\"Anna's Träger 🦾\"/></robot>", ".urdf");

        var run = await CliRun.OfAsync("kinematics", file.Path, "--json");

        Assert.That(run.Output, Does.Contain(@"Anna's Tr\u00e4ger"));
        Assert.That(run.Output.Where(character => !char.IsAscii(character)), Is.Empty);
        Assert.That(JsonDocument.Parse(run.Output).RootElement.GetProperty("root").GetString(), Is.EqualTo("Anna's Träger 🦾"));
    }

    [TestCase("lead=0", 0, 0.1)]
    [TestCase("lead=0.25", 0.25, 0.6)]
    [TestCase(" lead = 0.3 , follow = -1e-3 ", 0.3, -0.001)]
    [TestCase("follow=0.30000000000000004", 0, 0.30000000000000004)]
    public async Task Kinematics_MimicJoint_FollowsUnlessGiven(string joints, double a, double b)
    {
        var run = await RunAsync("--json", "--joints=" + joints);

        Assert.That((X(run, "a"), X(run, "b")), Is.EqualTo((a, b)));
    }

    [Test]
    public async Task Kinematics_NoJointValues_UsesZero()
    {
        var run = await RunAsync("--json");

        Assert.That((X(run, "a"), X(run, "b")), Is.EqualTo((0.0, 0.1)));
    }

    [Test]
    public async Task Kinematics_ValueOutsideLimits_ComputesAndWarns()
    {
        var run = await RunAsync("--joints", "lead=-0.25", "--json");

        Assert.That(run.ExitStatus, Is.EqualTo(0));
        Assert.That(X(run, "a"), Is.EqualTo(-0.25));
        Assert.That(run.Errors.TrimEnd(), Is.EqualTo("nowpose: " + KinematicsMessages.BeyondLimits("lead", -0.25, "m", 0, 0.5)));
    }

    [Test]
    public async Task Kinematics_MimicJointOutsideItsLimits_ComputesAndWarns()
    {
        var run = await RunAsync("--joints", "lead=0.5", "--json");

        Assert.That(run.ExitStatus, Is.EqualTo(0));
        Assert.That(X(run, "b"), Is.EqualTo(1.1));
        Assert.That(run.Errors.TrimEnd(), Is.EqualTo("nowpose: " + KinematicsMessages.BeyondLimits("follow", 1.1, "m", -1, 0.8)));
    }

    [Test]
    public async Task Kinematics_DefaultOutsideTheLimits_ComputesAndWarns()
    {
        using var file = new TemporaryFile(Slide.Replace("lower=\"0\"", "lower=\"0.2\"", StringComparison.Ordinal), ".urdf");

        var run = await CliRun.OfAsync("kinematics", file.Path, "--joints", "follow=0", "--json");

        Assert.That(run.ExitStatus, Is.EqualTo(0));
        Assert.That(X(run, "a"), Is.EqualTo(0));
        Assert.That(run.Errors.TrimEnd(), Is.EqualTo("nowpose: " + KinematicsMessages.BeyondLimits("lead", 0, "m", 0.2, 0.5)));
    }

    [Test]
    public async Task Kinematics_NoJsonOption_PrintsAMatrixPerLink()
    {
        var run = await RunAsync("--joints", "lead=0.125");

        Assert.That(run.ExitStatus, Is.EqualTo(0));
        Assert.That(run.Lines[0], Is.EqualTo(KinematicsMessages.Title("slide", "base").TrimEnd()));
        Assert.That(run.Output, Does.Contain("\na\n     1.000000     0.000000     0.000000     0.125000\n"));
    }

    [TestCase("youbot", "tool_centre_point")]
    [TestCase("ur5", "tool0")]
    [TestCase("ur5e", "tool0")]
    public async Task Kinematics_NameOfIncludedRobot_LoadsTheRobot(string robot, string tool)
    {
        var run = await CliRun.OfAsync("kinematics", robot, "--json");

        Assert.That(run.ExitStatus, Is.EqualTo(0), run.Errors);
        Assert.That(run.Output, Does.Contain('"' + tool + '"'));
    }

    static readonly string[][] InvalidJoints =
    [
        ["nothing=1", KinematicsMessages.NotAMovingJoint(KinematicsMessages.UnknownJoint("nothing"), "lead, follow")],
        ["mount=1", KinematicsMessages.NotAMovingJoint(KinematicsMessages.FixedJoint("mount"), "lead, follow")],
        ["lead=1,lead=1", KinematicsMessages.JointTwice("lead")],
        ["lead=x", KinematicsMessages.NotANumber("lead", "x", "m")],
        ["lead=NaN", KinematicsMessages.NotANumber("lead", "NaN", "m")],
        ["lead=", KinematicsMessages.NotANumber("lead", "", "m")],
        ["lead", KinematicsMessages.NotAPair("lead")],
        ["lead=1,", KinematicsMessages.NotAPair("")],
        [" ", KinematicsMessages.NotAPair("")],
        ["lead=1.5e308", KinematicsMessages.TooLarge],
    ];

    [TestCaseSource(nameof(InvalidJoints))]
    public async Task Kinematics_InvalidJoints_PrintsOneLineAndExitsWith2(string joints, string message)
    {
        var run = await RunAsync("--joints", joints, "--json");

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Output, Is.Empty);
        Assert.That(run.Complaints, Has.Length.EqualTo(1).And.All.StartsWith("nowpose: " + message), run.Errors);
    }

    [Test]
    public async Task Kinematics_InvalidUrdf_NamesFileLineAndElement()
    {
        using var file = new TemporaryFile("<robot name='r'>\n<link name='a'/>\n<link name='b'/></robot>", ".urdf");

        var run = await CliRun.OfAsync("kinematics", file.Path);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors, Is.EqualTo(ConsoleMessages.Line($"{file.Path}:3: link 'b': {UrdfMessages.TwoRoots("'a'")}\n")));
        Assert.That(run.Complaints, Has.Length.EqualTo(1));
    }

    static readonly string Robots = PlantMessages.Robots("youbot, ur5, ur3e, ur5e, ur10e, ur16e");

    static readonly string[][] UnknownRobots =
    [
        ["no-such-robot", PathMessages.NotFound("no-such-robot", Robots)],
        [".", PlantMessages.IsAFolder(".", Robots)],
        [" ", PlantMessages.NoRobot(Robots)],
    ];

    [TestCaseSource(nameof(UnknownRobots))]
    public async Task Kinematics_UnknownRobot_ListsTheAllowedNames(string robot, string message)
    {
        var run = await CliRun.OfAsync("kinematics", robot);

        Assert.That(run.ExitStatus, Is.EqualTo(2));
        Assert.That(run.Errors.TrimEnd(), Is.EqualTo("nowpose: " + message));
    }
}
