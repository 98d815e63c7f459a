using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Pairing;

namespace Nowpose.Unity.Cell
{
    /// <summary>
    /// Applies a paired cell to a session and a base anchor. Applies only changed values: a change of the connection reconnects the session, and
    /// a change of the markers may release the lock of the base.
    /// </summary>
    sealed class AppliedCell
    {
        PairedCell _connected, _anchored;

        /// <summary>Connects the session to the gateway of the cell; disconnects it if no cell is ready.</summary>
        /// <returns>False if the session has no settings yet. Call this method again in the next frame.</returns>
        public bool Connect(MrilSession session, PairedCell cell, string headsetName)
        {
            if (cell == null || !cell.IsReady)
            {
                if (_connected != null) Leave(session);
                return true;
            }
            if (_connected != null && IsSameConnection(_connected, cell)) return true;
            if (session.Settings == null) return false;
            var publishesDisplayed = session.Settings.Connection.PublishesDisplayed;
            session.Settings = session.Settings.With(cell.Newest.ToConnection(cell.Token, headsetName, publishesDisplayed));
            _connected = cell;
            session.Connect();
            return true;
        }

        /// <summary>Passes the markers of the cell to the base anchor.</summary>
        /// <param name="anchor">The base anchor; null if the scene has none.</param>
        /// <returns>Whether the base is now that of another cell. All poses relative to it are then invalid.</returns>
        public bool Place(BaseAnchor anchor, PairedCell cell)
        {
            if (anchor == null || IsSamePlace(_anchored, cell)) return false;
            var before = anchor.Cell;
            var markers = new List<BaseMarker>();
            if (cell != null)
                foreach (var code in cell.Codes)
                    if (code.Marker != null) markers.Add(new BaseMarker(code.Text, code.Marker.ToPose(), code.SizeMetres));
            // A code without a marker pose does not determine the pose of the base, so the anchor uses its own markers.
            if (markers.Count > 0) anchor.Use(cell.Cell, markers);
            else if (_anchored != null) anchor.UseFields();
            _anchored = markers.Count > 0 ? cell : null;
            return anchor.Cell != before;
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
