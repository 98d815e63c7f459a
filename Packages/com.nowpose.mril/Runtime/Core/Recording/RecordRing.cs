using System.Threading;

namespace Nowpose.Recording
{
    /// <summary>
    /// Passes records from any thread to the writing thread. Never blocks: if the ring is full, records are lost and counted.
    /// </summary>
    /// <remarks>
    /// Implements Vyukov's bounded queue: each slot has the turn number at which it may next be filled or emptied, so a record is visible
    /// only once it is complete, and a thread that is suspended while it fills a record delays only the later records.
    /// </remarks>
    sealed class RecordRing
    {
        readonly SessionRecord[] _records;
        readonly long[] _turns;
        long _filled, _emptied, _lost;

        /// <param name="capacity">A power of two.</param>
        /// <param name="numbers">See <see cref="SessionRecord"/>.</param>
        public RecordRing(int capacity, int numbers)
        {
            _records = new SessionRecord[capacity];
            _turns = new long[capacity];
            for (var i = 0; i < capacity; i++)
            {
                _records[i] = new SessionRecord(numbers);
                _turns[i] = i;
            }
        }

        /// <summary>Number of records lost since the start because the ring was full.</summary>
        public long Lost => Interlocked.Read(ref _lost);

        /// <summary>Gets a record to fill and pass to <see cref="Publish"/>; null if the ring is full. Thread-safe; allocates nothing.</summary>
        public SessionRecord TryClaim(RecordKind kind)
        {
            var place = Volatile.Read(ref _filled);
            while (true)
            {
                var ahead = Volatile.Read(ref _turns[IndexOf(place)]) - place;
                if (ahead < 0)
                {
                    Interlocked.Increment(ref _lost);
                    return null;
                }
                var seen = ahead > 0 ? Volatile.Read(ref _filled) : Interlocked.CompareExchange(ref _filled, place + 1, place);
                if (ahead == 0 && seen == place) break;
                place = seen;
            }
            var record = _records[IndexOf(place)];
            record.Place = place;
            record.Kind = kind;
            return record;
        }

        public void Publish(SessionRecord record) => Volatile.Write(ref _turns[IndexOf(record.Place)], record.Place + 1);

        /// <summary>Gets the oldest record, valid until <see cref="Release"/>. Only for the writing thread.</summary>
        public bool TryPeek(out SessionRecord record)
        {
            record = _records[IndexOf(_emptied)];
            return Volatile.Read(ref _turns[IndexOf(_emptied)]) == _emptied + 1;
        }

        /// <summary>Frees the oldest record's slot.</summary>
        public void Release()
        {
            _records[IndexOf(_emptied)].DropReferences();
            Volatile.Write(ref _turns[IndexOf(_emptied)], _emptied + _records.Length);
            _emptied++;
        }

        int IndexOf(long place) => (int)(place & (_records.Length - 1));
    }
}
