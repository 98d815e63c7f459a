using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Pairing;

namespace Nowpose.Unity.Cell
{
    /// <summary>Applies a paired cell to session and anchor. Applies only changed values, because each change costs a connection or a lock.</summary>
    sealed class AppliedCell
    {
        PairedCell _connected, _anchored;

        /// <summary>Applies the cell to the session; returns false if the session has no settings yet, so that the call must be repeated.</summary>
        public bool Connect(MrilSession session, PairedCell cell, string headsetName)
        {
            if (cell == null || !cell.IsReady)
            {
                if (_connected != null) Leave(session);
                return true;
            }
            if (_connected != null && IsSameConnection(_connected, cell)) return true;
            if (session.Settings == null) return false;
            session.Settings = session.Settings.With(cell.Newest.ToConnection(cell.Token, headsetName));
            // Set before the event, because a listener may throw after the connection is made.
            _connected = cell;
            session.Connect();
            return true;
        }

        /// <param name="anchor">Null for none.</param>
        public void Place(BaseAnchor anchor, PairedCell cell)
        {
            if (anchor == null || IsSamePlace(_anchored, cell)) return;
            var markers = new List<BaseMarker>();
            if (cell != null)
                foreach (var code in cell.Codes)
                    if (code.Marker != null) markers.Add(new BaseMarker(code.Text, code.Marker.ToPose(), code.SizeMetres));
            // A code without an offset does not determine the base, which stays where the user or the scene placed it.
            if (markers.Count > 0 || _anchored != null) anchor.Use(cell?.Cell ?? "", markers);
            _anchored = markers.Count > 0 ? cell : null;
        }

        void Leave(MrilSession session)
        {
            _connected = null;
            session.Disconnect();
            session.Settings = null;
        }

        static bool IsSameConnection(PairedCell one, PairedCell other) =>
            one.Token == other.Token && one.Newest.HasSameGateway(other.Newest);

        static bool IsSamePlace(PairedCell one, PairedCell other)
        {
            if (one == null || other == null || one.Cell != other.Cell || one.Codes.Count != other.Codes.Count) return one == other;
            for (var i = 0; i < one.Codes.Count; i++)
                if (one.Codes[i].Text != other.Codes[i].Text) return false;
            return true;
        }
    }
}
