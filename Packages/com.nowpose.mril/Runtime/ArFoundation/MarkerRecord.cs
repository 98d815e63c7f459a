using UnityEngine;

namespace Nowpose.ArFoundation
{
    /// <summary>State of one trackable, kept by a marker source from frame to frame.</summary>
    sealed class MarkerRecord
    {
        public MarkerRecord(string id) => Id = id;

        public string Id { get; }

        /// <summary>Content of the marker; null until the device has decoded it.</summary>
        public string Payload { get; set; }

        /// <summary>Headset time of the last sighting; null before the first sighting.</summary>
        public HeadsetTime? LastSeen { get; set; }

        /// <summary>Pose in the scene at the last sighting; null before the first sighting.</summary>
        public Pose? SeenAt { get; set; }

        /// <summary>Time of the last sighting on the device's own clock, in s; null before the first sighting.</summary>
        public float? LastSeenSeconds { get; set; }

        /// <summary>Number of the last reading that contained the trackable.</summary>
        internal int Reading { get; set; }
    }
}
