using System.Globalization;

namespace UnityEngine.XR.ARSubsystems;

public interface ITrackable
{
    TrackableId trackableId { get; }
    Pose pose { get; }
    TrackingState trackingState { get; }
}

public struct TrackableId(ulong subId1, ulong subId2) : IEquatable<TrackableId>
{
    public static TrackableId invalidId => default;

    public ulong subId1 { get; set; } = subId1;
    public ulong subId2 { get; set; } = subId2;

    public override string ToString() => string.Format(CultureInfo.InvariantCulture, "{0}-{1}", subId1.ToString("X16"), subId2.ToString("X16"));
    public override int GetHashCode() => HashCode.Combine(subId1, subId2);
    public override bool Equals(object obj) => obj is TrackableId id && Equals(id);
    public bool Equals(TrackableId other) => subId1 == other.subId1 && subId2 == other.subId2;
    public static bool operator ==(TrackableId lhs, TrackableId rhs) => lhs.Equals(rhs);
    public static bool operator !=(TrackableId lhs, TrackableId rhs) => !lhs.Equals(rhs);
}

public enum TrackingState
{
    None,
    Limited,
    Tracking,
}
