using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>A position relative to the head of a viewer, in cylindrical coordinates: azimuth, horizontal distance and height.</summary>
    readonly struct AroundHead
    {
        /// <summary>
        /// Maximum vertical component of the viewing direction for which the viewing direction determines the heading. If it is larger, the direction
        /// to the top of the head determines the heading.
        /// </summary>
        const float Steep = 0.95f;

        public AroundHead(float azimuth, float distance, float height) => (Azimuth, Distance, Height) = (azimuth, distance, height);

        /// <summary>Angle in degrees about the vertical, from the world's z axis towards its x axis.</summary>
        public float Azimuth { get; }

        /// <summary>Horizontal distance in metres.</summary>
        public float Distance { get; }

        /// <summary>Height above the eyes in metres.</summary>
        public float Height { get; }

        /// <summary>Returns the position of a point in the world relative to a head.</summary>
        public static AroundHead Of(Vector3 point, Vector3 head)
        {
            var way = point - head;
            return new AroundHead(AzimuthOf(way), Mathf.Sqrt(way.x * way.x + way.z * way.z), way.y);
        }

        /// <summary>Returns the heading of a head, as an azimuth in degrees, independent of its pitch and roll.</summary>
        public static float HeadingOf(Quaternion head)
        {
            var forward = head * Vector3.forward;
            if (Mathf.Abs(forward.y) < Steep) return AzimuthOf(forward);
            return AzimuthOf(head * Vector3.up * -Mathf.Sign(forward.y));
        }

        /// <summary>Returns the world pose of an upright object at this position that faces the head.</summary>
        public Pose From(Vector3 head)
        {
            var turn = Quaternion.Euler(0, Azimuth, 0);
            return new Pose(head + turn * new Vector3(0, Height, Distance), turn);
        }

        public AroundHead Towards(in AroundHead goal, float part) => new AroundHead(
            Mathf.LerpAngle(Azimuth, goal.Azimuth, part), Mathf.Lerp(Distance, goal.Distance, part), Mathf.Lerp(Height, goal.Height, part));

        public bool IsWithin(float degrees, float metres, in AroundHead goal) =>
            Mathf.Abs(Mathf.DeltaAngle(Azimuth, goal.Azimuth)) <= degrees
            && Mathf.Abs(Distance - goal.Distance) <= metres && Mathf.Abs(Height - goal.Height) <= metres;

        static float AzimuthOf(Vector3 way) => Mathf.Atan2(way.x, way.z) * Mathf.Rad2Deg;
    }
}
