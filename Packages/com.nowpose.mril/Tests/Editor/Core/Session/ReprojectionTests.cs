using System.Linq;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Session;
using NUnit.Framework;

namespace Nowpose.Tests.Core.Session
{
    public class ReprojectionTests
    {
        static CompensationSession NewSession() => new CompensationSession(
            new SessionSettings(new ConnectionSettings("127.0.0.1"), VisualisationLatency.FromMilliseconds(40)), TestRobot.Model, new SetClock());

        static string DiagnosticOf(CompensationSession session, string key) =>
            session.Listener.Diagnostics().Values.Where(value => value.Key == key).Select(value => value.Value).SingleOrDefault();

        [Test]
        public void Reprojection_NotReported_IsUnknownAndNotInDiagnostics()
        {
            var session = NewSession();

            Assert.That(session.Statistics(default).Reprojection, Is.EqualTo(ReprojectionMode.Unknown));
            Assert.That(DiagnosticOf(session, "reprojection"), Is.Null);
        }

        [Test]
        public void Reprojection_Reported_IsInStatisticsAndDiagnostics()
        {
            var session = NewSession();

            session.Reprojection = ReprojectionMode.PlanarManual;

            Assert.That(session.Statistics(default).Reprojection, Is.EqualTo(ReprojectionMode.PlanarManual));
            Assert.That(DiagnosticOf(session, "reprojection"), Is.EqualTo("planar_manual"));
        }

        [TestCase(DepthSubmission.Unknown, null)]
        [TestCase(DepthSubmission.Active, "active")]
        [TestCase(DepthSubmission.NoMainCamera, "no_main_camera")]
        public void DepthSubmission_Reported_IsInStatisticsAndDiagnostics(DepthSubmission depth, string expected)
        {
            var session = NewSession();

            session.DepthSubmission = depth;

            Assert.That(session.Statistics(default).DepthSubmission, Is.EqualTo(depth));
            Assert.That(DiagnosticOf(session, "depth_submission"), Is.EqualTo(expected));
        }
    }
}
