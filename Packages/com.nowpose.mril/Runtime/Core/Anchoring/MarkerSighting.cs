using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>What a marker source knows of one marker at the moment.</summary>
    /// <remarks>
    /// Room frame: the application's origin with the axes of the URDF (x forward, y left, z up), metres. Marker frame: its origin in the
    /// centre of the printed code, x to the right along the print, y to its upper edge, z out of the print towards who reads it.
    /// </remarks>
    public readonly struct MarkerSighting
    {
        /// <param name="id">Tells the marker from all others of its source for as long as the source runs.</param>
        /// <param name="payload">
        /// Text of the code; null while it is not read. Of one put there by hand null says that its frame is the robot's base
        /// frame.
        /// </param>
        /// <param name="pose">Marker frame in the room frame. Not checked: devices report the origin, and numbers that are none.</param>
        /// <param name="sizeMetres">Length of an edge; 0 where it is not known.</param>
        /// <param name="lastSeen">When a camera saw it last, which a source may go on saying <paramref name="tracking"/> long after.</param>
        public MarkerSighting(
            string id, string payload, in RigidTransform pose, double sizeMetres, HeadsetTime lastSeen, MarkerTracking tracking)
        {
            Id = id;
            Payload = payload;
            Pose = pose;
            SizeMetres = sizeMetres;
            LastSeen = lastSeen;
            Tracking = tracking;
        }

        public string Id { get; }
        public string Payload { get; }
        public RigidTransform Pose { get; }
        public double SizeMetres { get; }
        public HeadsetTime LastSeen { get; }
        public MarkerTracking Tracking { get; }
    }
}
