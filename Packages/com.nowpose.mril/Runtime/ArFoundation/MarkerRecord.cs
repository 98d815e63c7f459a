using UnityEngine;

namespace Nowpose.ArFoundation
{
    /// <summary>The state of one trackable that a marker source keeps between frames.</summary>
    sealed class MarkerRecord
    {
        public MarkerRecord(string id) => Id = id;

        public string Id { get; }

        /// <summary>Content of the marker; null while it is not decoded.</summary>
        public string Payload { get; set; }

        /// <summary>Headset time of the last sighting; null before the first.</summary>
        public HeadsetTime? LastSeen { get; set; }

        /// <summary>Pose at the last sighting, in the scene; null before the first.</summary>
        public Pose? SeenAt { get; set; }

        /// <summary>The device's own time of <see cref="LastSeen"/>, in s; null before the first sighting.</summary>
        public float? LastSeenSeconds { get; set; }

        /// <summary>Number of the last reading that contained the trackable.</summary>
        internal int Reading { get; set; }
    }
}
