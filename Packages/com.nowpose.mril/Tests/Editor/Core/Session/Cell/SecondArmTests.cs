using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Protocol;
using Nowpose.Session;
using NUnit.Framework;
using static Nowpose.Tests.Core.Session.Cell.GripScene;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests objects on a second arm, which is not between the robot's base and its tool.</summary>
    public class SecondArmTests
    {
        static readonly RobotModel TwoArms = UrdfReader.Read(@"<robot name='two_arms'>
            <link name='torso'/><link name='right'/><link name='tool0'/><link name='left'/>
            <joint name='right_joint' type='revolute'><parent link='torso'/><child link='right'/><axis xyz='0 0 1'/>
                <limit lower='-3' upper='3' velocity='2' effort='1'/></joint>
            <joint name='tool' type='fixed'><parent link='right'/><child link='tool0'/></joint>
            <joint name='left_joint' type='revolute'><parent link='torso'/><child link='left'/><axis xyz='0 0 1'/>
                <limit lower='-3' upper='3' velocity='2' effort='1'/></joint>
        </robot>", "test");

        // With Hold, the joints are also held on purpose.
        [Test]
        public void StateOf_SamplesOfTheSecondArmStop_IsHeldAlsoOutsideTheRange([Values] OutsideRangeResponse response, [Values] bool isOutside)
        {
            var cell = new CellSession(range: new ConstantLatencyRange(15, RenderTimeSourceKind.DisplayGpuTime), outsideRange: response);
            var robot = cell.Session.Robots.Add("two", TwoArms);
            foreach (var name in new[] { "in_right", "in_left" }) cell.Session.Frames.Need(name);
            cell.Send("two/tool0", "in_right", 0, At(1, 0), isStationary: true);
            cell.Send("two/left", "in_left", 0, At(1, 0), isStationary: true);
            var names = new[] { "right_joint", "left_joint" };
            cell.Sampling = t => robot.Intake.Add(
                new JointStateMessage(ControlTime.FromSeconds(t), t < 20.5 ? names : new[] { "right_joint" }, t < 20.5 ? new[] { t - 20, t - 20 } : new[] { t - 20 }),
                HeadsetTime.FromSeconds(t + CellSession.Latency));
            for (var i = 0; i < 60; i++) cell.Session.Rendered(Lengths.Ms(isOutside ? 20 : 10), RenderTimeSourceKind.DisplayGpuTime);
            var expected = isOutside ? PoseState.OutsideRange : PoseState.Current;

            cell.Run(0.5);
            Assert.That((StateOf(cell, "in_right"), StateOf(cell, "in_left")), Is.EqualTo((expected, expected)));
            cell.Run(1.5);

            Assert.That((StateOf(cell, "in_right"), StateOf(cell, "in_left")), Is.EqualTo((expected, PoseState.Held)));
        }
    }
}
