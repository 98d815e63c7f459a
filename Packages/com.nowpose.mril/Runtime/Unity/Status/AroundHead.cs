using UnityEngine;

namespace Nowpose.Unity.Status
{
    /// <summary>A place around an upright viewer: which way, how far, how high.</summary>
    readonly struct AroundHead
    {
        /// <summary>Steeper than this nobody looks anywhere in particular: then the top of the head tells the way.</summary>
        const float Steep = 0.95f;

        public AroundHead(float azimuth, float distance, float height)
        {
            Azimuth = azimuth;
            Distance = distance;
            Height = height;
        }

        /// <summary>Degrees about the vertical from the world's z axis towards its x axis.</summary>
        public float Azimuth { get; }

        /// <summary>Horizontal, metres.</summary>
        public float Distance { get; }

        /// <summary>Above the eyes, metres.</summary>
        public float Height { get; }

        /// <summary>Where a point is as seen from a head.</summary>
        public static AroundHead Of(Vector3 point, Vector3 head)
        {
            var way = point - head;
            return new AroundHead(AzimuthOf(way), Mathf.Sqrt(way.x * way.x + way.z * way.z), way.y);
        }

        /// <summary>Which way a head looks, whatever way it nods or tilts.</summary>
        public static float HeadingOf(Quaternion head)
        {
            var forward = head * Vector3.forward;
            if (Mathf.Abs(forward.y) < Steep) return AzimuthOf(forward);
            return AzimuthOf(head * Vector3.up * -Mathf.Sign(forward.y));
        }

        /// <summary>The place in the world, upright and turned so that the head reads it.</summary>
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
