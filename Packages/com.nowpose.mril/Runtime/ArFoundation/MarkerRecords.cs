using System.Collections.Generic;
using UnityEngine.XR.ARSubsystems;

namespace Nowpose.ArFoundation
{
    /// <summary>Stores one record per trackable that the device lists. Allocates only when a new trackable appears.</summary>
    sealed class MarkerRecords
    {
        readonly Dictionary<TrackableId, MarkerRecord> _records = new Dictionary<TrackableId, MarkerRecord>();
        readonly List<TrackableId> _gone = new List<TrackableId>();
        int _reading;

        /// <summary>Starts a reading of all trackables.</summary>
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

        /// <summary>Ends the reading. Removes the records that were not requested since its start: the device no longer lists them.</summary>
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
