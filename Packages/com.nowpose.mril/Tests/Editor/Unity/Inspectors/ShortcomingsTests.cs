using System.Collections.Generic;
using System.Linq;
using Nowpose.Editor;
using Nowpose.Editor.Inspectors;
using Nowpose.Editor.Messages;
using Nowpose.Tests.Unity.Robot;
using Nowpose.Unity;
using NUnit.Framework;
using UnityEngine;

namespace Nowpose.Tests.Unity.Inspectors
{
    public class ShortcomingsTests
    {
        readonly SceneObjects _scene = new SceneObjects();

        [TearDown]
        public void Clean() => _scene.Destroy();

        RobotRig Rig(Transform parent = null)
        {
            var rig = _scene.New<RobotRig>("Robot", parent);
            rig.gameObject.AddComponent<PoseAppearance>();
            return rig;
        }

        [Test]
        public void Session_WithoutSettings_IsReported()
        {
            var session = _scene.New<MrilSession>("Session");
            Assert.That(Of(session).Single().Message, Is.EqualTo(ShortcomingTexts.Settings));

            session.With("_settings", _scene.Asset<SessionSettingsAsset>("Settings"));

            Assert.That(Of(session), Is.Empty);
        }

        [Test]
        public void Rig_BelowASession_IsComplete()
        {
            var session = _scene.New<MrilSession>("Session");
            session.gameObject.SetActive(false);

            Assert.That(Of(Rig(session.transform)), Is.Empty);
        }

        [Test]
        public void Rig_BesideTheOnlySession_OffersThatSession()
        {
            var session = _scene.New<MrilSession>("The Session");
            var rig = Rig();

            var shortcoming = Of(rig).Single();
            Assert.That(shortcoming.Message, Is.EqualTo(ShortcomingTexts.RigSession));
            Assert.That(shortcoming.FixLabel, Is.EqualTo("Use 'The Session'"));
            shortcoming.Fix();

            Assert.That(Of(rig), Is.Empty);
            _scene.New<MrilSession>("Another");
            Assert.That(Of(rig), Is.Empty, "the session is assigned");
            Assert.That(session != null);
        }

        [Test]
        public void Rig_BesideTwoSessions_OffersNoSession()
        {
            _scene.New<MrilSession>("One");
            _scene.New<MrilSession>("Two");

            Assert.That(Of(Rig()).Single().FixLabel, Is.Null);
        }

        [TestCase("", RigPose.Displayed, true)]
        [TestCase("arm2", RigPose.Displayed, false)]
        [TestCase("", RigPose.Held, false)]
        public void Rigs_OfOneSession_AreReportedIfTheyDisplayTheSameRobot(string robot, RigPose shows, bool isReported)
        {
            var session = _scene.New<MrilSession>("Session").transform;
            RobotRig one = Rig(session), two = Rig(session).With("_robotNamespace", robot).With("_shows", shows);
            Rig(_scene.New<MrilSession>("Another").transform);
            one.name = "One";

            Assert.That(Of(two).Select(each => each.Message), Is.EqualTo(isReported ? new[] { ShortcomingTexts.SameRobot("One") } : System.Array.Empty<string>()));
            Assert.That(Of(one).Length, Is.EqualTo(isReported ? 1 : 0));
        }

        [TestCase("arm1", true)]
        [TestCase("arm2", false)]
        public void Rigs_NamespaceOfTheSettingsAndNone_AreReportedIfTheyDisplayTheSameRobot(string robot, bool isReported)
        {
            var session = _scene.New<MrilSession>("Session").With(
                "_settings", _scene.Asset<SessionSettingsAsset>("Settings").With("_robotNamespace", "arm1"));
            var named = Rig(session.transform).With("_robotNamespace", robot);
            var unnamed = Rig(session.transform);

            Assert.That((Of(named).Length, Of(unnamed).Length), Is.EqualTo(isReported ? (1, 1) : (0, 0)));
        }

        [Test]
        public void Rig_BesideTheBaseAnchor_IsReportedUntilItIsBelowIt()
        {
            var session = _scene.New<MrilSession>("Session").transform;
            var rig = Rig(session);
            Assert.That(Of(rig), Is.Empty, "the session has no base anchor");

            var anchor = _scene.New<BaseAnchor>("Base Anchor", session).transform;
            Assert.That(Of(rig).Single().Message, Is.EqualTo(ShortcomingTexts.RigBesideBase));
            rig.transform.SetParent(anchor);

            Assert.That(Of(rig), Is.Empty);
        }

        [Test]
        public void BaseAnchor_ScaledWithMarkers_IsReported()
        {
            var session = _scene.New<MrilSession>("Session").transform;
            session.localScale = Vector3.one * 0.1f;
            var anchor = _scene.New<BaseAnchor>("Base Anchor", session);
            Assert.That(Of(anchor), Is.Empty, "a cell in miniature is placed by hand");

            anchor.With("_markers", new List<AnchorMarker> { new AnchorMarker("a", Vector3.zero, Vector3.zero) });
            Assert.That(Of(anchor).Single().Message, Is.EqualTo(ShortcomingTexts.ScaledBase));
            session.localScale = Vector3.one;

            Assert.That(Of(anchor), Is.Empty);
        }

        [TestCase("Fixture", "", true)]
        [TestCase("Conveyor", "", false)]
        [TestCase("Fixture", "other.json", false)]
        public void StationaryObjects_OfOneSession_AreReportedIfTheyHaveTheSameFrameInTheSameFile(string frame, string file, bool isReported)
        {
            var session = _scene.New<MrilSession>("Session").transform;
            _scene.New<StationaryObject>("Fixture", session);
            _scene.New<StationaryObject>("Fixture", _scene.New<MrilSession>("Another").transform);

            var other = _scene.New<StationaryObject>("Other", session).With("_frame", frame).With("_fileName", file);

            Assert.That(
                Of(other).Select(each => each.Message), Is.EqualTo(isReported ? new[] { ShortcomingTexts.SameFrame("Fixture", frame) } : System.Array.Empty<string>()));
        }

        [Test]
        public void Gripper_BesideTheOnlyRig_OffersThatRig()
        {
            _scene.New<RobotRig>("Robot", _scene.New<MrilSession>("Session").transform);
            var gripper = _scene.New<VirtualGripper>("Gripper");

            Assert.That(Of(gripper).Single().FixLabel, Is.EqualTo("Use 'Robot'"));
        }

        [Test]
        public void PartOfARobot_BesideTheOnlyDisplayedRig_OffersThatRig()
        {
            var session = _scene.New<MrilSession>("Session").transform;
            var rig = Rig(session);
            Rig(session).With("_shows", RigPose.Held);
            var parts = new Component[]
            {
                _scene.New<GripByReach>("Grip", session), _scene.New<PlannedPath>("Path", session), _scene.New<VirtualGripper>("Gripper", session),
            };

            foreach (var part in parts)
            {
                var shortcoming = Of(part).Single();
                Assert.That((shortcoming.Message, shortcoming.FixLabel), Is.EqualTo((ShortcomingTexts.Rig, "Use 'Robot'")), part.name);
                shortcoming.Fix();

                Assert.That(part.Shown("_rig"), Is.SameAs(rig));
                Assert.That(Of(part), Is.Empty, part.name);
            }
        }

        [Test]
        public void PartOfARobot_BelowARig_IsComplete()
        {
            var rig = Rig(_scene.New<MrilSession>("Session").transform).transform;

            Assert.That(Of(_scene.New<GripByReach>("Grip", rig)).Concat(Of(_scene.New<PlannedPath>("Path", rig))), Is.Empty);
        }

        [Test]
        public void PartsOfASignal_WithoutAppearance_OfferOne()
        {
            var session = _scene.New<MrilSession>("Session").transform;
            foreach (var driver in new Component[] { _scene.New<ActuatedPart>("Jaw", session), _scene.New<CellSignal>("Lamp", session) })
            {
                Assert.That(Of(driver), Is.Empty, "nothing is drawn");
                _scene.New<MeshRenderer>("Drawn", driver.transform);
                var shortcoming = Of(driver).Single();
                Assert.That(shortcoming.Message, Is.EqualTo(ShortcomingTexts.SignalAppearance), driver.name);
                shortcoming.Fix();

                Assert.That(Of(driver), Is.Empty);
                Assert.That(driver.GetComponent<PoseAppearance>().Shown("_substitute"), Is.Not.Null);
            }
        }

        [Test]
        public void PartsOfASignal_BelowAnAppearance_AreComplete()
        {
            var above = _scene.New<PoseAppearance>("Conveyor", _scene.New<MrilSession>("Session").transform).transform;
            var part = _scene.New<ActuatedPart>("Stop", above);
            _scene.New<MeshRenderer>("Drawn", part.transform);

            Assert.That(Of(part), Is.Empty);
        }

        [Test]
        public void RenderTimeSource_OnTheSession_IsComplete()
        {
            var session = _scene.New<MrilSession>("Session");

            Assert.That(Of(session.gameObject.AddComponent<RenderTimeSource>()), Is.Empty);
            Assert.That(Of(_scene.New<RenderTimeSource>("Elsewhere")).Single().FixLabel, Is.EqualTo("Use 'Session'"));
        }

        [Test]
        public void PanelAndAppearance_WithoutReferences_AreReported()
        {
            var panel = _scene.New<StatusPanel>("Panel");
            _scene.New<TextMesh>("Cell", panel.transform);

            Assert.That(Of(panel).Select(s => s.FixLabel), Is.EqualTo(new[] { null, "Use 'Cell'" }));
            Assert.That(Of(_scene.New<PoseAppearance>("Looks")).Single().Message, Is.EqualTo(ShortcomingTexts.ShownSession));
        }

        [Test]
        public void Appearance_OpaquePartsBelow_OffersASubstitute()
        {
            var appearance = _scene.New<PoseAppearance>("Looks", _scene.New<MrilSession>("Session").transform);
            Assert.That(Of(appearance), Is.Empty);
            var part = _scene.New<MeshRenderer>("Part", appearance.transform);
            part.sharedMaterial = PackageAsset.Hologram.Load<Material>();
            Assert.That(Of(appearance), Is.Empty, "the material has _Fade and _Hatch");

            part.sharedMaterial = _scene.Material("Steel");
            var shortcoming = Of(appearance).Single();
            Assert.That(shortcoming.Message, Is.EqualTo(ShortcomingTexts.Substitute));
            Assert.That(shortcoming.FixLabel, Is.EqualTo("Use 'Hologram'"));
            shortcoming.Fix();

            Assert.That(Of(appearance), Is.Empty);
        }

        [Test]
        public void Fix_SeveralObjects_ChangesOnlyTheIncompleteObjects()
        {
            var session = _scene.New<MrilSession>("Session");
            var below = Rig(session.transform);
            RobotRig one = Rig().With("_robotNamespace", "arm2"), two = Rig().With("_robotNamespace", "arm3");

            Shortcomings.Of(new Object[] { below, one, two }).Single().Fix();

            Assert.That(Of(one).Concat(Of(two)), Is.Empty);
            Assert.That(one.Shown("_session"), Is.SameAs(session));
            Assert.That(below.Shown("_session"), Is.Null);
        }

        [Test]
        public void Fix_SeveralPanels_AssignsEachItsOwnText()
        {
            var session = _scene.New<MrilSession>("Session").transform;
            StatusPanel one = _scene.New<StatusPanel>("One", session), two = _scene.New<StatusPanel>("Two", session);
            TextMesh first = _scene.New<TextMesh>("Cell", one.transform), second = _scene.New<TextMesh>("Cell", two.transform);

            Shortcomings.Of(new Object[] { one, two }).Single().Fix();

            Assert.That((one.Shown("_cell"), two.Shown("_cell")), Is.EqualTo(((object)first, (object)second)));
        }

        static Shortcoming[] Of(Object component) => Shortcomings.Of(new[] { component }).ToArray();
    }
}
