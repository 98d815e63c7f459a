using UnityEngine.XR.ARSubsystems;

namespace UnityEngine.XR.ARFoundation;

public struct TrackableCollection<TTrackable>
{
    readonly Dictionary<TrackableId, TTrackable> _trackables;

    public TrackableCollection(Dictionary<TrackableId, TTrackable> trackables) => _trackables = trackables;

    public Enumerator GetEnumerator() => new(_trackables);

    public bool TryGetTrackable(TrackableId trackableId, out TTrackable trackable) => _trackables.TryGetValue(trackableId, out trackable);

    public struct Enumerator
    {
        Dictionary<TrackableId, TTrackable>.Enumerator _trackables;

        public Enumerator(Dictionary<TrackableId, TTrackable> trackables) => _trackables = trackables.GetEnumerator();

        public TTrackable Current => _trackables.Current.Value;

        public bool MoveNext() => _trackables.MoveNext();

        public void Dispose() => _trackables.Dispose();
    }
}
