using Nowpose.Kinematics;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>A robot with an arm of one metre with two joints, and a gripper with a finger joint and a mimic joint.</summary>
    static class TestRobot
    {
        const string Urdf = @"<robot name='test'>
            <link name='base'/><link name='upper'/><link name='lower'/><link name='tool_centre_point'/><link name='finger'/><link name='thumb'/>
            <joint name='shoulder' type='revolute'><parent link='base'/><child link='upper'/><axis xyz='0 0 1'/>
                <limit lower='-3' upper='3' velocity='2' effort='1'/></joint>
            <joint name='elbow' type='continuous'><parent link='upper'/><child link='lower'/><origin xyz='0.5 0 0'/><axis xyz='0 0 1'/></joint>
            <joint name='tool' type='fixed'><parent link='lower'/><child link='tool_centre_point'/><origin xyz='0.5 0 0'/></joint>
            <joint name='grip' type='prismatic'><parent link='tool_centre_point'/><child link='finger'/><axis xyz='0 1 0'/>
                <limit lower='0' upper='0.05' velocity='1' effort='1'/></joint>
            <joint name='grip_mirror' type='prismatic'><parent link='tool_centre_point'/><child link='thumb'/><axis xyz='0 1 0'/>
                <limit lower='-0.05' upper='0' velocity='1' effort='1'/><mimic joint='grip' multiplier='-1'/></joint>
        </robot>";

        public static readonly RobotModel Model = UrdfReader.Read(Urdf, "test");

        /// <summary>The same robot, but the elbow turns by half the angle of the shoulder unless it has samples of its own.</summary>
        public static readonly RobotModel WithMimicElbow = UrdfReader.Read(
            Urdf.Replace("<joint name='elbow' type='continuous'>", "<joint name='elbow' type='continuous'><mimic joint='shoulder' multiplier='0.5'/>"), "test");
    }
}
