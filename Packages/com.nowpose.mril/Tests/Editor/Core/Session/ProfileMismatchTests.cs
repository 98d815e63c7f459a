using System;
using System.Linq;
using Nowpose.Latency;
using Nowpose.Latency.Conditions;
using Nowpose.Latency.Profile;
using Nowpose.Network;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class ProfileMismatchTests
    {
        static CompensationSession NewSession(bool rewrites = false) => new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40), rewriteBeforeRender: rewrites),
            TestRobot.Model, new SetClock());

        static LatencyProfile Profile(DisplayConditions conditions) => new LatencyProfile(
            50, 1, conditions, new DateTime(2026, 11, 20, 0, 0, 0, DateTimeKind.Utc), CalibrationMethod.VisibleLight, 300);

        static string[] FieldsOf(CompensationSession session) =>
            session.Statistics(default).ProfileMismatches.Select(each => each.Field).ToArray();

        static string DiagnosticOf(CompensationSession session) =>
            session.Listener.Diagnostics().Values.Where(value => value.Key == "profile_mismatch").Select(value => value.Value).SingleOrDefault();

        [Test]
        public void ProfileMismatches_UnknownConditionsOrNoProfile_IsEmpty()
        {
            var session = NewSession();
            session.Conditions = new DisplayConditions("HoloLens 2", 60, "Direct3D11");
            var without = FieldsOf(session);

            session.Calibrate(Profile(DisplayConditions.Unknown));

            Assert.That(without, Is.Empty);
            Assert.That(FieldsOf(session), Is.Empty);
            Assert.That(DiagnosticOf(session), Is.Null);
        }

        [Test]
        public void ProfileMismatches_GraphicsSettingsDiffer_AreReportedAndTheProfileStaysInUse()
        {
            var session = NewSession();
            session.Calibrate(Profile(new DisplayConditions(graphicsApi: "Direct3D11", graphicsJobs: "MultiThreaded")));

            session.Conditions = new DisplayConditions(graphicsApi: "Direct3D12", graphicsJobs: "NativeGraphicsJobs");

            Assert.That(FieldsOf(session), Is.EqualTo(new[] { "graphics_api", "graphics_jobs" }));
            Assert.That(DiagnosticOf(session), Is.EqualTo("graphics_api,graphics_jobs"));
            Assert.That(session.Visualisation.Length, Is.EqualTo(Lengths.Ms(50)));
        }

        [Test]
        public void ProfileMismatches_RewriteBeforeRender_UsesTheSettings([Values] bool rewrites)
        {
            var session = NewSession(rewrites);

            session.Calibrate(Profile(new DisplayConditions(rewritesBeforeRender: true)));

            Assert.That(FieldsOf(session), Is.EqualTo(rewrites ? Array.Empty<string>() : new[] { "rewrite_before_render" }));
        }

        [Test]
        public void ProfileMismatches_ReprojectionChangesAtRunTime_AreUpdated()
        {
            var session = NewSession();
            session.Calibrate(Profile(new DisplayConditions(reprojection: ReprojectionMode.Depth)));
            var unknown = FieldsOf(session);

            session.Reprojection = ReprojectionMode.OrientationOnly;
            var other = FieldsOf(session);
            session.Reprojection = ReprojectionMode.Depth;

            Assert.That(unknown, Is.Empty);
            Assert.That(other, Is.EqualTo(new[] { "reprojection" }));
            Assert.That(FieldsOf(session), Is.Empty);
        }

        // Listeners compare the list by reference in each frame.
        [Test]
        public void ProfileMismatches_EqualConditions_ReturnsTheSameList()
        {
            var session = NewSession();
            session.Calibrate(Profile(new DisplayConditions(graphicsApi: "Direct3D11")));
            session.Conditions = new DisplayConditions(graphicsApi: "Vulkan");
            var before = session.ProfileMismatches;

            session.Conditions = new DisplayConditions(graphicsApi: "Vulkan");

            Assert.That(session.ProfileMismatches, Is.SameAs(before));
        }
    }
}
