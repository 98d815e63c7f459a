using System.Linq;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Tests.Core.Kinematics;
using Nowpose.Tests.Unity.Robot;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEditor;
using UnityEngine;

namespace Nowpose.Tests.Unity
{
    /// <summary>Tests an instance of each cell prefab in edit mode. No script runs, but the references between the parts are set.</summary>
    [TestFixture("Nowpose Robot Cell", "youbot")]
    [TestFixture("Nowpose Robot Cell UR5", "ur5")]
    [TestFixture("Nowpose Robot Cell (Any Robot)", "ur5")]
    public class CellPrefabTests
    {
        readonly string _prefab;
        readonly RobotModel _model;
        GameObject _cell;
        MrilSession _session;
        RobotRig _displayed;
        Ghost _ghost;

        public CellPrefabTests(string prefab, string robot)
        {
            _prefab = prefab;
            _model = UrdfFiles.Robot(robot);
        }

        [SetUp]
        public void Instantiate()
        {
            _cell = Object.Instantiate(AssetDatabase.LoadAssetAtPath<GameObject>("Packages/com.nowpose.mril/Runtime/Prefabs/" + _prefab + ".prefab"));
            _session = _cell.GetComponent<MrilSession>();
            _ghost = _cell.GetComponentInChildren<Ghost>(true);
            _displayed = _cell.GetComponentsInChildren<RobotRig>().Single();
        }

        [TearDown]
        public void Destroy() => Object.DestroyImmediate(_cell);

        [Test]
        public void Parts_EachReference_PointsToThisInstance()
        {
            var rigs = _cell.GetComponentsInChildren<RobotRig>(true);
            var panel = _cell.GetComponentInChildren<StatusPanel>();

            Assert.That(rigs.Length, Is.EqualTo(2));
            foreach (var rig in rigs) Assert.That(rig.Shown("_session"), Is.SameAs(_session), rig.name);
            Assert.That(_cell.GetComponent<RenderTimeSource>().Shown("_session"), Is.SameAs(_session));
            var looks = _cell.GetComponentsInChildren<PoseAppearance>(true);
            Assert.That(looks, Is.Not.Empty);
            foreach (var look in looks) Assert.That(look.Shown("_session"), Is.SameAs(_session), look.name);
            Assert.That(panel.Shown("_session"), Is.SameAs(_session));
            Assert.That(((Component)panel.Shown("_cell")).transform.IsChildOf(panel.transform), Is.True);
            Assert.That(panel.GetComponent<BodyFollow>(), Is.Not.Null);
            Assert.That(_ghost.Shown("_displayed"), Is.SameAs(_displayed));
            var words = (TextMesh)_displayed.GetComponent<PoseAppearance>().Shown("_words");
            Assert.That(words.transform.IsChildOf(_displayed.transform), Is.True);
        }

        [Test]
        public void Ghost_ByDefault_IsHidden()
        {
            Assert.That(_ghost.Visible, Is.False);
            Assert.That(_ghost.GapMetres, Is.Null);
            Assert.That(_ghost.GetComponent<RobotRig>().Shows, Is.EqualTo(RigPose.Held));
            Assert.That(_displayed.Shows, Is.EqualTo(RigPose.Displayed));

            _ghost.Visible = true;

            Assert.That(_ghost.gameObject.activeInHierarchy, Is.True);
        }

        [Test]
        public void Rigs_BoundToTheRobot_HaveTheGripperAtTheFlange()
        {
            var isKnown = _session.RobotAsset != null;
            if (isKnown) Assert.That(_session.RobotAsset.Read().SourceHash, Is.EqualTo(_model.SourceHash));
            var positions = RobotPoses.Any(_model, new System.Random(5));
            _ghost.Visible = true;
            foreach (var rig in _cell.GetComponentsInChildren<RobotRig>(true))
            {
                var objects = rig.GetComponentsInChildren<Transform>(true).Length;
                var gripper = rig.GetComponentInChildren<VirtualGripper>(true);

                rig.Bind(_model);
                gripper.Mount(rig);
                rig.Apply(positions);

                RobotPoses.RequireAgreement(rig, positions, rig.name + ", seed 5");
                Assert.That(gripper.Flange, Is.SameAs(rig.Flange));
                Assert.That(gripper.transform.IsChildOf(rig.Flange), Is.EqualTo(isKnown));
                Assert.That(Vector3.Distance(gripper.transform.position, rig.Flange.position), Is.LessThan(1e-5));
                var isBuilt = rig.GetComponentsInChildren<Transform>(true).Length > objects;
                Assert.That(isBuilt, Is.EqualTo(!isKnown), "the rig builds the robot only if the prefab does not contain it");
                gripper.Unmount();
            }
        }

        [Test]
        public void Session_InTheEditor_DoesNotRun()
        {
            Assert.That(_session.Session, Is.Null);
            Assert.That(_session.Frame, Is.Null);
            Assert.That(_session.Statistics, Is.Null);
            Assert.That(_session.Problem, Is.Null);
            Assert.That(_cell.GetComponent<RenderTimeSource>().Source, Is.EqualTo(RenderTimeSourceKind.None));
            Assert.DoesNotThrow(() => _session.Connect());
            Assert.DoesNotThrow(() => _session.Disconnect());
        }

        [Test]
        public void Appearance_RefreshedInEditMode_DoesNotHideParts()
        {
            var look = _displayed.GetComponent<PoseAppearance>();

            look.Refresh();

            foreach (var drawn in look.GetComponentsInChildren<Renderer>(true)) Assert.That(drawn.forceRenderingOff, Is.False, drawn.name);
        }
    }
}
