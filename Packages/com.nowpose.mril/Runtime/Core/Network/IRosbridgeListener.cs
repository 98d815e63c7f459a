using Nowpose.Protocol;

namespace Nowpose.Network
{
    /// <summary>What a <see cref="RosbridgeClient"/> serves. Called on the client's threads.</summary>
    interface IRosbridgeListener
    {
        /// <param name="message">
        /// Checked against every rule that needs no clock. A <see cref="Session.CompensationSession"/> reuses it for a later message once a frame
        /// has taken its samples: a listener that passes it on to a session copies the values that it keeps.
        /// </param>
        /// <param name="arrival">When its last byte was read.</param>
        void Received(JointStateMessage message, HeadsetTime arrival);

        /// <summary>Where the control system means to go.</summary>
        /// <param name="message">As of <see cref="Received"/>.</param>
        /// <param name="arrival">When its last byte was read.</param>
        void Planned(JointTrajectoryMessage message, HeadsetTime arrival);

        /// <summary>The gateway's status of the joints that are not live.</summary>
        /// <param name="message">As of <see cref="Received"/>.</param>
        /// <param name="arrival">When its last byte was read.</param>
        void StatusReceived(JointStatusMessage message, HeadsetTime arrival);

        /// <summary>A robot description. May take its time: samples do not wait for it.</summary>
        /// <param name="urdf">Within the limits of its length, and not checked otherwise.</param>
        void Described(string urdf);

        void Dropped(DropReason reason);

        /// <summary>What is shown, up to twenty times a second; null while there is nothing to say, or nothing new.</summary>
        JointStateMessage Displayed();

        /// <summary>The headset's state for the once-a-second publication; null while there is nothing to say.</summary>
        DiagnosticsMessage Diagnostics();
    }
}
