using System.Collections.Generic;
using UnityEngine.XR.ARSubsystems;

namespace Nowpose.ArFoundation
{
    /// <summary>Stores the states of a source's trackables while the device lists them. Allocates only for new ones.</summary>
    sealed class MarkerRecords
    {
        readonly Dictionary<TrackableId, MarkerRecord> _records = new Dictionary<TrackableId, MarkerRecord>();
        readonly List<TrackableId> _gone = new List<TrackableId>();
        int _reading;

        /// <summary>Starts a new reading.</summary>
        public void Begin() => _reading++;

        public MarkerRecord Of(TrackableId id)
        {
            if (!_records.TryGetValue(id, out var record))
            {
                record = new MarkerRecord(id.ToString());
                _records.Add(id, record);
            }
            record.Reading = _reading;
            return record;
        }

        /// <summary>Ends a reading: removes the records that were not requested, because the device no longer lists them.</summary>
        public void End()
        {
            foreach (var pair in _records)
                if (pair.Value.Reading != _reading) _gone.Add(pair.Key);
            foreach (var id in _gone) _records.Remove(id);
            _gone.Clear();
        }

        public void Clear() => _records.Clear();
    }
}
