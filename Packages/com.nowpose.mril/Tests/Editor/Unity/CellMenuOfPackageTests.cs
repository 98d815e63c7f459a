using System.Collections.Generic;
using System.Linq;
using Nowpose.Editor;
using Nowpose.Editor.Inspectors;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Tests.Unity
{
    /// <summary>Tests the menu with the prefabs of the package.</summary>
    public class CellMenuOfPackageTests
    {
        GameObject _instance;

        static IEnumerable<PackageAsset> Cells => new[] { PackageAsset.RobotCell, PackageAsset.RobotCellUr5 };

        [TearDown]
        public void Clean()
        {
            if (_instance != null) Object.DestroyImmediate(_instance);
        }

        [Test]
        public void Place_RobotCell_CreatesACompleteInstance()
        {
            foreach (var cell in Cells)
            {
                _instance = CellMenu.Place(cell, null);

                Assert.That(_instance.name, Is.EqualTo(cell.Name));
                Assert.That(PrefabUtility.GetCorrespondingObjectFromSource(_instance), Is.SameAs(cell.Load<GameObject>()));
                Assert.That(_instance.GetComponentsInChildren<MrilSession>(true).Length, Is.EqualTo(1), cell.Name);
                foreach (var component in _instance.GetComponentsInChildren<MonoBehaviour>(true))
                    Assert.That(Shortcomings.Of(new Object[] { component }).Select(s => s.Message), Is.Empty, cell.Name + ", " + component.name);
                Clean();
            }
        }

        [Test]
        public void Place_VirtualGripper_CreatesItBelowTheSelectedRig()
        {
            _instance = new GameObject("Robot");
            var rig = _instance.AddComponent<RobotRig>();

            var gripper = CellMenu.Place(PackageAsset.VirtualGripper, _instance);

            Assert.That(gripper.transform.parent, Is.SameAs(rig.transform));
            Assert.That(Shortcomings.Of(new Object[] { gripper.GetComponent<VirtualGripper>() }), Is.Empty);
        }

        [Test]
        public void Place_AnotherRobot_IsInTheSessionOfTheSelectedCell()
        {
            _instance = CellMenu.Place(PackageAsset.RobotCell, null);
            var anchor = _instance.GetComponentInChildren<BaseAnchor>(true);

            var robot = CellMenu.Place(PackageAsset.Robot, anchor.gameObject);

            Assert.That(robot.transform.parent, Is.SameAs(anchor.transform));
            Assert.That(robot.GetComponentsInChildren<RobotRig>(true).Select(rig => rig.Shows), Is.EquivalentTo(new[] { RigPose.Displayed, RigPose.Held }));
            Assert.That(robot.GetComponentsInChildren<VirtualGripper>(true).Length, Is.EqualTo(2));
            foreach (var component in robot.GetComponentsInChildren<MonoBehaviour>(true).Where(each => !(each is RobotRig)))
                Assert.That(Shortcomings.Of(new Object[] { component }).Select(s => s.Message), Is.Empty, component.name);
        }

        [Test]
        public void Fix_SessionWithoutSettings_AssignsTheDefaultSettings()
        {
            _instance = new GameObject("Session");
            var session = _instance.AddComponent<MrilSession>();
            var shortcoming = Shortcomings.Of(new Object[] { session }).Single();
            Assert.That(shortcoming.FixLabel, Is.EqualTo("Use 'Default Session Settings'"));

            shortcoming.Fix();

            Assert.That(Shortcomings.Of(new Object[] { session }), Is.Empty);
            Assert.That(PackageAsset.DefaultSettings.Load<SessionSettingsAsset>().ToSettings(), Is.Not.Null);
        }
    }
}
