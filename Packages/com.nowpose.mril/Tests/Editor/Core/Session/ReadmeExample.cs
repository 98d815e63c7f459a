using System;
using Nowpose.Kinematics;
using Nowpose.Latency;
using Nowpose.Network;
using Nowpose.Protocol;
using Nowpose.Session;

namespace Nowpose.Tests.Core.Session
{
    /// <summary>Compiles the code of the package's README. A test of the repository checks that the README contains the same code.</summary>
    static class ReadmeExample
    {
        internal static UnityPose Use(string urdfText, string token)
        {
            var robot = UrdfReader.Read(urdfText, "robot.urdf");
            var pin = CertificatePin.Parse("sha256/47DEQpj8HBSa+/TImW+5JCeuQeRkm5NMpJWZG3hSuFU=");
            var connection = new ConnectionSettings("192.168.0.20", pin: pin, token: token);
            var settings = new SessionSettings(connection, new VisualisationLatency(TimeSpan.FromMilliseconds(40)));
            var clock = new StopwatchHeadsetClock();

            using var session = new CompensationSession(settings, robot, clock);
            session.Connect();                           // connects, and reconnects automatically

            // every frame:
            var frame = session.Tick(clock.Now);         // allocates nothing
            if (frame.State != PoseState.Current) { /* fade it: the pose is not the robot's present one */ }
            var tool = UnityFrame.ToUnity(frame.ToolPose);
            return tool;
        }
    }
}
