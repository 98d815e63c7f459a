using Nowpose.Kinematics;

namespace Nowpose.Anchoring
{
    /// <summary>Current data about one marker, reported by a marker source.</summary>
    /// <remarks>
    /// Room frame: the application's origin with the axes of the URDF (x forward, y left, z up), in metres. Marker frame: origin at the
    /// centre of the printed code, x to the right along the print, y to its upper edge, z out of the print towards the reader.
    /// </remarks>
    public readonly struct MarkerSighting
    {
        /// <param name="id">Identifier of the marker within its source, valid for as long as the source runs.</param>
        /// <param name="payload">
        /// Text of the code; null while it has not been read. For a marker placed by hand, null means that its frame is the robot's base
        /// frame.
        /// </param>
        /// <param name="pose">Marker frame in the room frame. Not validated: devices also report the origin and invalid numbers.</param>
        /// <param name="sizeMetres">Length of an edge; 0 when it is unknown.</param>
        /// <param name="lastSeen">
        /// Time at which a camera last saw the marker. It may be old although <paramref name="tracking"/> is unchanged.
        /// </param>
        /// <param name="keepsUpright">
        /// Whether a marker placed by hand gives only the position and the heading of the base, whose z axis then points up. Other markers ignore it.
        /// </param>
        public MarkerSighting(
            string id, string payload, in RigidTransform pose, double sizeMetres, HeadsetTime lastSeen, MarkerTracking tracking,
            bool keepsUpright = false)
        {
            Id = id;
            Payload = payload;
            Pose = pose;
            SizeMetres = sizeMetres;
            LastSeen = lastSeen;
            Tracking = tracking;
            KeepsUpright = keepsUpright;
        }

        public string Id { get; }
        public string Payload { get; }
        public RigidTransform Pose { get; }
        public double SizeMetres { get; }
        public HeadsetTime LastSeen { get; }
        public MarkerTracking Tracking { get; }

        /// <summary>Whether a marker placed by hand gives only the position and the heading of the base, whose z axis then points up.</summary>
        public bool KeepsUpright { get; }
    }

    /// <summary>Quality of a marker's pose according to its source.</summary>
    public enum MarkerTracking
    {
        /// <summary>The marker is not tracked: the pose is old or missing.</summary>
        None,

        /// <summary>The pose is approximate or remembered.</summary>
        Limited,

        /// <summary>The source tracks the marker. The pose may still be stale, see <see cref="MarkerSighting.LastSeen"/>.</summary>
        Tracking,

        /// <summary>
        /// The marker is placed by hand: its pose is exact by definition and independent of the view. While a person moves it,
        /// <see cref="MarkerSighting.LastSeen"/> advances with time; afterwards it is the time at which the marker was released.
        /// </summary>
        Placed,
    }
}
