using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>Receives the messages of a <see cref="RosbridgeClient"/> and supplies its publications. Called on the client's threads.</summary>
    interface IRosbridgeListener
    {
        /// <param name="message">
        /// The message, which passed all checks that need no clock. A <see cref="Session.CompensationSession"/> reuses it for a later message
        /// once a frame has used its samples: a listener that passes it to a session must copy the values that it keeps.
        /// </param>
        /// <param name="arrival">Time at which its last byte was read.</param>
        void Received(JointStateMessage message, HeadsetTime arrival);

        /// <summary>Receives set-points that the control system publishes ahead of time.</summary>
        /// <param name="message">As in <see cref="Received"/>.</param>
        /// <param name="arrival">Time at which its last byte was read.</param>
        void Planned(JointTrajectoryMessage message, HeadsetTime arrival);

        /// <summary>Receives the gateway's status of the joints that are not live.</summary>
        /// <param name="message">As in <see cref="Received"/>.</param>
        /// <param name="arrival">Time at which its last byte was read.</param>
        void StatusReceived(JointStatusMessage message, HeadsetTime arrival);

        /// <summary>Receives a robot description. May block, because samples do not wait for it.</summary>
        /// <param name="urdf">Text within the length limit; not checked otherwise.</param>
        void Described(string urdf);

        void Dropped(DropReason reason);

        /// <summary>Gets the displayed joints, up to twenty times a second; null if there are none or none new.</summary>
        JointStateMessage Displayed();

        /// <summary>Gets the headset's state, once a second; null if there is none to publish.</summary>
        DiagnosticsMessage Diagnostics();
    }
}
