using Nowpose.Kinematics;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session.Cell
{
    /// <summary>Tests objects whose poses are in the base frame of the robot's controller, which is a fixed link of the description.</summary>
    public class ControllerBaseTests
    {
        // As in the descriptions of Universal Robots, where the controller's base frame is turned by 180 degrees against the root.
        const string WithBase = @"<robot name='with base'>
            <link name='base_link'/><link name='base'/><link name='tool0'/>
            <joint name='base_link-base_fixed_joint' type='fixed'><parent link='base_link'/><child link='base'/>
                <origin xyz='0 0 0.33' rpy='0 0 3.141592653589793'/></joint>
            <joint name='shoulder' type='continuous'><parent link='base_link'/><child link='tool0'/><axis xyz='0 0 1'/></joint>
        </robot>";

        [Test]
        public void Frame_ParentIsTheBaseLinkOfTheController_IsShownInItsAxes()
        {
            var cell = new CellSession();
            cell.Session.Robots.Add("arm2", UrdfReader.Read(WithBase, "test"));
            cell.Session.Frames.Need("part");
            cell.Send("arm2/base", "part", 0, RigidTransform.FromXyzRpy(0.4, 0.1, 0.05, 0, 0, 0), isStationary: true);
            cell.Run(1);

            var shown = cell.Session.Frames.Find("part").World;

            Assert.That(new[] { shown.X, shown.Y, shown.Z }, Is.EqualTo(new[] { -0.4, -0.1, 0.38 }).Within(1e-9));
        }
    }
}
