using System;
using System.Globalization;
using Nowpose.Kinematics;
using Nowpose.Messages;

namespace Nowpose.Anchoring.Tracking
{
    /// <summary>Describes a tracker's state in one line.</summary>
    /// <remarks>Creates a new string only when the content changes. If only numbers change, creates at most one string per second.</remarks>
    sealed class BaseStatusText
    {
        static readonly TimeSpan Refresh = TimeSpan.FromSeconds(1);

        /// <summary>Maximum age of the newest report of a marker that counts as in view.</summary>
        static readonly TimeSpan InView = TimeSpan.FromSeconds(1);

        /// <summary>Time without a report of any code after which the camera may not be working.</summary>
        static readonly TimeSpan CameraTimeout = TimeSpan.FromSeconds(10);

        readonly AnchoringSettings _settings;
        Subject _shown;
        HeadsetTime _since;
        HeadsetTime? _searching;
        HeadsetTime _last;

        public BaseStatusText(AnchoringSettings settings) => _settings = settings;

        public string Text { get; private set; } = BaseStatusMessages.Placed;

        public void Update(BaseTracker tracker, HeadsetTime now)
        {
            // The time before the first frame and the duration of a pause of the application are not counted as search time.
            if (now - _last > Refresh || now < _last) _searching = null;
            _last = now;
            var subject = SubjectOf(tracker, now);
            if (subject.HasKindOf(_shown) && (subject.IsNear(_shown) || now - _since < Refresh)) return;
            (_shown, _since) = (subject, now);
            Text = TextOf(subject, tracker);
        }

        Subject SubjectOf(BaseTracker tracker, HeadsetTime now)
        {
            if (tracker.State != BaseAnchorState.Searching) _searching = null;
            if (tracker.RefusedPayload != null && tracker.State != BaseAnchorState.Moved && tracker.State != BaseAnchorState.Lost)
                return new Subject(Kind.Refused, tracker.RefusedPayload);
            switch (tracker.State)
            {
                case BaseAnchorState.Searching: return Search(tracker, now);
                case BaseAnchorState.Moved: return Move(tracker);
                case BaseAnchorState.Locked: return Lock(tracker);
                case BaseAnchorState.Restored when tracker.Unconfirmed is MapCorrection correction:
                    return new Subject(Kind.Unconfirmed, tracker.Problem, a: Mm(correction.Metres), b: Tenths(correction.Radians));
                case BaseAnchorState.Restored: return new Subject(Kind.Restored, tracker.Problem);
                case BaseAnchorState.Lost when tracker.HeldPlace.IsRemoved: return new Subject(Kind.Removed, tracker.Problem);
                case BaseAnchorState.Lost when tracker.HeldPlace.Elsewhere is MapCorrection jump:
                    return new Subject(Kind.Elsewhere, a: (int)Math.Min(Math.Ceiling(10 * jump.Metres), 1e6), b: Tenths(jump.Radians));
                case BaseAnchorState.Lost: return new Subject(Kind.Lost, tracker.Problem);
                default: return new Subject(Kind.Placed);
            }
        }

        static Subject Lock(BaseTracker tracker)
        {
            var isCorrected = tracker.IsCorrected;
            return new Subject(
                Kind.Locked, tracker.Lock, tracker.Conflict, tracker.Problem, isCorrected ? Mm(tracker.CorrectedMetres) : 0,
                isCorrected ? Tenths(tracker.CorrectedRadians) : 0, isCorrected ? 1 : 0);
        }

        Subject Search(BaseTracker tracker, HeadsetTime now)
        {
            _searching ??= now;
            if (tracker.IsBeingPlaced) return new Subject(Kind.BeingPlaced);
            if (tracker.Conflict is { } conflict)
                return new Subject(Kind.Conflict, conflict.Marker, conflict.Other, null, Mm(conflict.Metres), Tenths(conflict.Radians));
            TrackedMarker newest = null;
            var seen = 0;
            for (var i = 0; i < tracker.Markers.Count; i++)
            {
                var marker = tracker.Markers[i];
                if (marker.IsFresh(now)) seen++;
                if (!(marker.LastReported is HeadsetTime reported) || now - reported > InView) continue;
                if (marker.IsFresh(now) && marker.IsReady && marker.IsAlternating) return new Subject(Kind.Alternates, marker.Marker);
                if (marker.IsFresh(now) && marker.IsReady && marker.IsMoving) return new Subject(Kind.Moving, marker.Marker);
                if (marker.IsFresh(now) && marker.IsReady && marker.SpreadMetres is double spread && spread > 0)
                    return new Subject(Kind.Scatters, marker.Marker, null, null, Mm(spread), Tenths(marker.SpreadRadians.Value));
                if (newest == null || reported > newest.LastReported) newest = marker;
            }
            if (seen > 0) return new Subject(Kind.Gathers, null, null, null, seen, 0);
            return newest != null && newest.Fault != SightingFault.None
                ? new Subject(Kind.Ignored, newest.Marker, count: (int)newest.Fault)
                : Look(tracker, now);
        }

        Subject Look(BaseTracker tracker, HeadsetTime now)
        {
            var since = tracker.LastReport is HeadsetTime reported && reported > _searching.Value ? reported : _searching.Value;
            var isCameraSuspect = tracker.SourceProblem == null && now - since > CameraTimeout;
            return new Subject(Kind.Looking, tracker.SourceProblem, count: isCameraSuspect ? 1 : 0);
        }

        static Subject Move(BaseTracker tracker)
        {
            TrackedMarker worst = null;
            var count = 0;
            for (var i = 0; i < tracker.Markers.Count; i++)
            {
                var marker = tracker.Markers[i];
                if (!marker.HasMoved) continue;
                count++;
                if (worst == null || marker.Watch.Metres > worst.Watch.Metres) worst = marker;
            }
            if (worst == null) return new Subject(Kind.Looking);
            return new Subject(Kind.Moved, worst.Marker, null, null, Mm(worst.Watch.Metres), Tenths(worst.Watch.Radians), count);
        }

        string TextOf(in Subject subject, BaseTracker tracker)
        {
            var off = subject.A + " mm, " + Number(subject.B / 10.0, "0.0") + "°";
            switch (subject.Kind)
            {
                case Kind.BeingPlaced: return BaseStatusMessages.BeingPlaced;
                case Kind.Refused: return BaseStatusMessages.NotOfThisBase(MarkerName.Of((string)subject.First));
                case Kind.Conflict: return BaseStatusMessages.Conflict(Name(subject.First), Name(subject.Second), off);
                case Kind.Alternates: return BaseStatusMessages.Alternates(Name(subject.First));
                case Kind.Unconfirmed:
                    return BaseStatusMessages.Unconfirmed(subject.A, Number(subject.B / 10.0, "0.0"), tracker.Lock.Markers > 0, tracker.Problem);
                case Kind.Scatters: return BaseStatusMessages.Scatters(Name(subject.First), off);
                case Kind.Gathers: return BaseStatusMessages.Gathers(subject.A, tracker.Markers.Count);
                case Kind.Ignored: return Name(subject.First) + " " + WhyIgnored((SightingFault)subject.Count);
                case Kind.Moving: return BaseStatusMessages.Moving(Name(subject.First));
                case Kind.Looking: return BaseStatusMessages.Looking(subject.Count > 0, (string)subject.First);
                case Kind.Moved: return BaseStatusMessages.Moved(subject.Count, Name(subject.First), off);
                case Kind.Locked: return Locked(tracker);
                case Kind.Removed: return BaseStatusMessages.Removed(tracker.Problem);
                case Kind.Restored: return BaseStatusMessages.Restored(tracker.Markers.Count > 0, tracker.Problem);
                case Kind.Lost: return BaseStatusMessages.Lost + BaseStatusMessages.Because(tracker.Problem);
                case Kind.Elsewhere:
                    return BaseStatusMessages.Elsewhere(
                        Number(tracker.ElsewhereMetres, "0.0"), Number(subject.B / 10.0, "0.0"), tracker.Markers.Count > 0);
                default: return BaseStatusMessages.Placed;
            }
        }

        string WhyIgnored(SightingFault fault)
        {
            switch (fault)
            {
                case SightingFault.TooFar: return BaseStatusMessages.TooFar(Number(_settings.MaxDistanceMetres, "0.##"));
                case SightingFault.TooOblique: return BaseStatusMessages.TooOblique;
                case SightingFault.Behind: return BaseStatusMessages.Behind;
                case SightingFault.OtherSize: return BaseStatusMessages.OtherSize;
                case SightingFault.TwoPlaces: return BaseStatusMessages.TwoPlaces;
                case SightingFault.Old: return BaseStatusMessages.NotInView;
                default: return BaseStatusMessages.NotPlaced;
            }
        }

        static string Locked(BaseTracker tracker)
        {
            var locked = tracker.Lock;
            var text = BaseStatusMessages.Locked(locked.Markers);
            if (locked.ChangeMetres > 0 || locked.ChangeRadians > 0)
                text += BaseStatusMessages.MovedBy(Number(1000 * locked.ChangeMetres, "0.0"), Number(Degrees(locked.ChangeRadians), "0.00"));
            if (locked.Nudge is RigidTransform nudge)
                text += BaseStatusMessages.NudgedBy(
                    Number(1000 * nudge.DistanceTo(RigidTransform.Identity), "0.0"),
                    Number(Degrees(nudge.AngleTo(RigidTransform.Identity)), "0.00"));
            if (tracker.Conflict is { } conflict)
                text += BaseStatusMessages.ConflictOfLock(Name(conflict.Marker), Mm(conflict.Metres), Number(Degrees(conflict.Radians), "0.0"));
            if (tracker.IsCorrected)
                text += BaseStatusMessages.Corrected(Mm(tracker.CorrectedMetres), Number(Degrees(tracker.CorrectedRadians), "0.0"));
            return text + BaseStatusMessages.Because(tracker.Problem);
        }

        static string Name(object marker) => MarkerName.Of(((BaseMarker)marker).Payload);

        static int Mm(double metres) => (int)Math.Min(Math.Round(1000 * metres), 1e6);

        static int Tenths(double radians) => (int)Math.Round(10 * Degrees(radians));

        static double Degrees(double radians) => radians * 180 / Math.PI;

        static string Number(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);

        enum Kind
        {
            Placed, BeingPlaced, Refused, Looking, Ignored, Gathers, Moving, Alternates, Scatters, Conflict, Restored, Unconfirmed, Locked, Moved, Lost,
            Elsewhere, Removed,
        }

        /// <summary>Content of the status text. Equal contents produce equal strings.</summary>
        readonly struct Subject
        {
            public readonly Kind Kind;
            public readonly object First, Second, Third;
            public readonly int A, B, Count;

            public Subject(Kind kind, object first = null, object second = null, object third = null, int a = 0, int b = 0, int count = 0)
            {
                Kind = kind;
                First = first;
                Second = second;
                Third = third;
                A = a;
                B = b;
                Count = count;
            }

            public bool HasKindOf(in Subject other) => Kind == other.Kind && First == other.First && Second == other.Second
                && Third == other.Third && Count == other.Count;

            /// <summary>Returns whether the numbers differ by no more than noise.</summary>
            public bool IsNear(in Subject other) => Kind == Kind.Gathers ? A == other.A : Math.Abs(A - other.A) < 2 && Math.Abs(B - other.B) < 3;
        }
    }
}
