using System.Collections.Generic;

namespace Nowpose.Anchoring
{
    /// <summary>Reports the markers in the room, for example from a device's code detection, from placement by hand, or from a recording.</summary>
    public interface IMarkerSource
    {
        /// <summary>Adds all markers that the source currently reports to the list, each once. Keeps the existing entries. Must not throw.</summary>
        /// <remarks>Called once per frame on the frame loop's thread; must be fast and must not allocate if no marker is new.</remarks>
        void Read(List<MarkerSighting> markers);
    }

    /// <summary>A source of markers that can report why it finds no markers.</summary>
    public interface IMarkerProblem
    {
        /// <summary>The problem in one line; null if nothing is wrong. Returns the same object as long as the text does not change.</summary>
        string Problem { get; }
    }
}
