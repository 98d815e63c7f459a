using System.Text.RegularExpressions;
using NUnit.Framework;
using Nowpose.Kinematics;

namespace Nowpose.Headless.Tests.Cli;

/// <summary>Tests the coupled axes that the manual's page about robot descriptions shows.</summary>
public class CoupledAxesPageTests
{
    static string Snippet() => Regex.Match(
        RepositoryFiles.Read($"{RepositoryFiles.Package}/Documentation~/robot-description.md"), "```xml\n(.*?)```", RegexOptions.Singleline).Groups[1].Value;

    static RobotModel Robot(string elbow) => UrdfReader.Read(
        $"""
        <robot name="arm"><link name="base_link"/><link name="link_2"/><link name="link_3"/><link name="tool0"/>
        <joint name="joint_2" type="revolute"><parent link="base_link"/><child link="link_2"/><axis xyz="0 1 0"/>
        <limit lower="-2" upper="2" effort="0" velocity="6"/></joint>
        {elbow}
        <joint name="flange" type="fixed"><parent link="link_3"/><child link="tool0"/><origin xyz="0.335 0 0"/></joint></robot>
        """,
        "page");

    static RigidTransform Tool(RobotModel robot, double joint2, double joint3)
    {
        double[] positions = [.. robot.MovingJoints.Select(joint => joint.Name == "joint_3" ? joint3 : joint2)];
        var poses = new RigidTransform[robot.Links.Count];
        new ForwardKinematics(robot).Compute(positions, poses);
        return poses[robot.Links.ToList().FindIndex(link => link.Name == "tool0")];
    }

    // The controller counts axis 3 from the horizontal: the forearm is at the angle of axis 3, and its start at the end of the upper arm.
    [TestCase(0, 0)]
    [TestCase(0.5, 0)]
    [TestCase(0.5, 0.3)]
    [TestCase(-0.7, 1.2)]
    public void Compute_SnippetWithAnglesOfTheController_HasTheForearmAtTheAngleOfAxis3(double joint2, double joint3)
    {
        var tool = Tool(Robot(Snippet()), joint2, joint3);

        Assert.That(tool.X, Is.EqualTo(0.3 * Math.Sin(joint2) + 0.335 * Math.Cos(joint3)).Within(1e-12));
        Assert.That(tool.Z, Is.EqualTo(0.3 * Math.Cos(joint2) + 0.335 * Math.Sin(joint3)).Within(1e-12));
    }

    [Test]
    public void Compute_DescriptionWithoutCoupling_IsWrongByTheAngleOfAxis2()
    {
        const string Uncoupled = """
            <joint name="joint_3" type="revolute"><parent link="link_2"/><child link="link_3"/><origin xyz="0 0 0.3"/><axis xyz="0 -1 0"/>
            <limit lower="-3" upper="4" effort="0" velocity="6"/></joint>
            """;

        Assert.That(Tool(Robot(Uncoupled), 0.5, 0.3).Z, Is.EqualTo(0.3 * Math.Cos(0.5) + 0.335 * Math.Sin(0.3 - 0.5)).Within(1e-12));
        Assert.That(
            Tool(Robot(Snippet()), 0.5, 0.3).Z, Is.EqualTo(Tool(Robot(Uncoupled), 0.5, 0.3 + 0.5).Z).Within(1e-12), "the mimic joint adds axis 2 to axis 3");
    }
}
