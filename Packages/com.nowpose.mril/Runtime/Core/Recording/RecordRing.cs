using System.Threading;

namespace Nowpose.Recording
{
    /// <summary>
    /// Records on their way from any thread to the one that writes them. Nobody waits: when it is full, records are lost and
    /// counted.
    /// </summary>
    /// <remarks>
    /// Vyukov's bounded queue: each place carries the turn at which it may be filled or emptied next, so that a record is seen
    /// only once it is whole and a thread that is held up between the two delays nothing but what comes after it.
    /// </remarks>
    sealed class RecordRing
    {
        readonly SessionRecord[] _records;
        readonly long[] _turns;
        long _filled, _emptied, _lost;

        /// <param name="capacity">A power of two.</param>
        /// <param name="numbers">As of <see cref="SessionRecord"/>.</param>
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

        /// <summary>Records that found no room since the start.</summary>
        public long Lost => Interlocked.Read(ref _lost);

        /// <summary>A record to fill, then to hand to <see cref="Publish"/>; null when there is no room. Any thread; allocates nothing.</summary>
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

        /// <summary>The oldest record, valid until <see cref="Release"/>. Of the writing thread only.</summary>
        public bool TryPeek(out SessionRecord record)
        {
            record = _records[IndexOf(_emptied)];
            return Volatile.Read(ref _turns[IndexOf(_emptied)]) == _emptied + 1;
        }

        /// <summary>Gives the oldest record's room free.</summary>
        public void Release()
        {
            Volatile.Write(ref _turns[IndexOf(_emptied)], _emptied + _records.Length);
            _emptied++;
        }

        int IndexOf(long place) => (int)(place & (_records.Length - 1));
    }
}
