using UnityEngine;

namespace Nowpose.ArFoundation
{
    /// <summary>What a source remembers of one trackable from frame to frame.</summary>
    sealed class MarkerRecord
    {
        public MarkerRecord(string id) => Id = id;

        public string Id { get; }

        /// <summary>Null while it is not read.</summary>
        public string Payload { get; set; }

        /// <summary>Null before the first.</summary>
        public HeadsetTime? LastSeen { get; set; }

        /// <summary>Where it was when it was seen last, in the scene; null before.</summary>
        public Pose? SeenAt { get; set; }

        /// <summary>The device's own time of <see cref="LastSeen"/>, seconds; null before the first.</summary>
        public float? LastSeenSeconds { get; set; }

        /// <summary>The reading in which it was there last.</summary>
        internal int Reading { get; set; }
    }
}
