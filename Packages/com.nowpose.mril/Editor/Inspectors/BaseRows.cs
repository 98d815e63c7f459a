using System;
using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Inspectors
{
    /// <summary>Creates the rows of a base anchor's inspector: rows for its lock, for the device's anchor, and for each marker.</summary>
    static class BaseRows
    {
        public static IEnumerable<(string Label, string Value)> Of(BaseTracker tracker)
        {
            yield return (InspectorTexts.LockSpread, tracker.Lock == null
                ? LiveText.Unknown
                : Offset(tracker.Lock.SpreadMetres, tracker.Lock.SpreadRadians));
            yield return (InspectorTexts.MovedByLock, tracker.Lock == null
                ? LiveText.Unknown
                : Offset(tracker.Lock.ChangeMetres, tracker.Lock.ChangeRadians));
            yield return (InspectorTexts.MovedByDevice, Offset(tracker.CorrectedMetres, tracker.CorrectedRadians));
            yield return (
                InspectorTexts.HeldByDevice, tracker.Problem ?? (tracker.IsHeld ? InspectorTexts.Held(tracker.KeptAs) : InspectorTexts.NotHeld));
            foreach (var marker in tracker.Markers)
                foreach (var row in Of(marker)) yield return row;
        }

        static IEnumerable<(string Label, string Value)> Of(TrackedMarker marker)
        {
            yield return (marker.Marker.Payload, Role(marker));
            yield return (InspectorTexts.Sightings, marker.Sightings + Ignored(marker.Ignored));
            yield return (InspectorTexts.OffBy, Offset(marker.DeviationMetres, marker.DeviationRadians));
        }

        static string Role(TrackedMarker marker)
        {
            if (marker.IsContradicted) return InspectorTexts.MarkerContradicted;
            if (marker.HasMoved) return InspectorTexts.MarkerMoved;
            if (marker.Fault != SightingFault.None) return InspectorTexts.Ignored(InspectorTexts.Of(marker.Fault));
            return marker.IsPart ? InspectorTexts.MarkerInLock : marker.Sightings > 0 ? InspectorTexts.MarkerSeen : InspectorTexts.MarkerNotSeen;
        }

        static string Ignored(SightingFaults ignored)
        {
            var text = "";
            for (var fault = SightingFault.NotTracked; fault <= SightingFault.TwoPlaces; fault++)
                if (ignored[fault] > 0) text += (text.Length > 0 ? ", " : "") + ignored[fault] + " " + InspectorTexts.Of(fault);
            return text.Length == 0 ? "" : "; " + InspectorTexts.Ignored(text);
        }

        static string Offset(double? metres, double? radians) => metres.HasValue
            ? LiveText.Mm(1000 * metres) + ", " + LiveText.Number(radians * (180 / Math.PI), "0.00", "°")
            : LiveText.Unknown;
    }
}
