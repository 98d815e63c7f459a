using System.Collections.Generic;

namespace Nowpose.Anchoring
{
    /// <summary>Reports the markers in the room, for example from a device's code detection, from placement by hand, or from a recording.</summary>
    public interface IMarkerSource
    {
        /// <summary>Adds all currently known markers to the list, each once, and keeps the entries in it. Must not throw.</summary>
        /// <remarks>Called once per frame on its thread; must be fast and must not allocate when no marker is new.</remarks>
        void Read(List<MarkerSighting> markers);
    }

    /// <summary>A source of markers that can report why it has none.</summary>
    public interface IMarkerProblem
    {
        /// <summary>The problem in one line; null without a problem. The same object as long as the text is the same.</summary>
        string Problem { get; }
    }
}
