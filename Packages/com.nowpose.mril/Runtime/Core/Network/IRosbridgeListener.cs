using System.Collections.Generic;
using Nowpose.Protocol;
using Nowpose.Protocol.Cell;

namespace Nowpose.Network
{
    /// <summary>
    /// Receives the messages of a <see cref="RosbridgeClient"/> and supplies the messages that the client publishes. Called on the client's
    /// threads.
    /// </summary>
    interface IRosbridgeListener
    {
        /// <param name="message">
        /// The message, which passed all checks that need no clock. A <see cref="Session.CompensationSession"/> reuses it after a frame has used
        /// its samples, so a listener that passes it to a session must copy the values that it keeps.
        /// </param>
        /// <param name="arrival">Time at which the last byte of the message was read.</param>
        /// <param name="robot">Namespace of the robot; empty for the robot without a namespace.</param>
        void Received(JointStateMessage message, HeadsetTime arrival, string robot = "");

        /// <summary>Receives set-points that the control system publishes ahead of time.</summary>
        /// <inheritdoc cref="Received"/>
        void Planned(JointTrajectoryMessage message, HeadsetTime arrival, string robot = "");

        /// <summary>Receives poses of the cell's frames.</summary>
        /// <param name="message">See <see cref="Received"/>.</param>
        /// <param name="isStationary">Whether the poses belong to stationary frames.</param>
        /// <param name="arrival">Time at which the last byte of the message was read.</param>
        void FramesReceived(TransformsMessage message, bool isStationary, HeadsetTime arrival);

        /// <summary>Receives values of the cell's signals.</summary>
        /// <param name="message">See <see cref="Received"/>.</param>
        /// <param name="arrival">Time at which the last byte of the message was read.</param>
        void SignalsReceived(SignalsMessage message, HeadsetTime arrival);

        /// <summary>Receives the gateway's status of the joints that are not live.</summary>
        /// <param name="message">See <see cref="Received"/>.</param>
        /// <param name="arrival">Time at which the last byte of the message was read.</param>
        void StatusReceived(JointStatusMessage message, HeadsetTime arrival);

        /// <summary>Receives the gateway's status of the signals whose source has ended.</summary>
        /// <param name="message">See <see cref="Received"/>; contains signals in place of joints.</param>
        /// <param name="arrival">Time at which the last byte of the message was read.</param>
        void SignalStatusReceived(JointStatusMessage message, HeadsetTime arrival);

        /// <summary>Receives a robot description. May block, because samples do not wait for it.</summary>
        /// <param name="urdf">Text within the length limit; its content is not checked.</param>
        /// <param name="robot">Namespace of the robot; empty for the robot without a namespace.</param>
        void Described(string urdf, string robot = "");

        /// <summary>Reports that a connection has opened, before its first message. It may lead to another gateway.</summary>
        void Connected(HeadsetTime at);

        /// <summary>Receives the version of the gateway. An older gateway does not report its version.</summary>
        void VersionReceived(string version);

        /// <summary>Receives the namespaces of the robots that the server serves, in alphabetical order.</summary>
        void NamespacesReceived(IReadOnlyList<string> names);

        void Dropped(DropReason reason);

        /// <summary>Gets the displayed joints; null without new positions. Called up to twenty times a second.</summary>
        JointStateMessage Displayed();

        /// <summary>
        /// Gets the headset's state; null if there is none to publish. Called once a second, and up to five times a second while
        /// <see cref="HasPoseChanged"/> is true.
        /// </summary>
        DiagnosticsMessage Diagnostics();

        /// <summary>Whether the state of the pose has changed since the newest diagnostics; false before the first.</summary>
        bool HasPoseChanged { get; }

        /// <summary>Whether a robot had no samples in the newest diagnostics. The client then asks the gateway for the namespaces.</summary>
        bool NeedsNamespaces { get; }
    }
}
