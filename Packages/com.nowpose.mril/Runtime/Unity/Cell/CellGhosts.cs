using System.Collections.Generic;
using UnityEngine;

namespace Nowpose.Unity.Cell
{
    /// <summary>The ghosts of a session: those of robots, and the tracked objects that show the newest pose.</summary>
    sealed class CellGhosts
    {
        readonly List<GameObject> _all = new List<GameObject>();

        public int Count => _all.Count;

        /// <summary>Whether any ghost is switched on.</summary>
        public bool IsAnyShown
        {
            get
            {
                foreach (var ghost in _all)
                    if (ghost != null && ghost.activeSelf) return true;
                return false;
            }
        }

        /// <summary>Finds the ghosts in the scene of a session, including those that are switched off.</summary>
        /// <param name="session">Null for no session.</param>
        /// <param name="further">Another ghost; null for none.</param>
        public void Find(MrilSession session, Ghost further)
        {
            _all.Clear();
            if (further != null) _all.Add(further.gameObject);
            if (session == null) return;
            foreach (var root in session.gameObject.scene.GetRootGameObjects())
            {
                foreach (var ghost in root.GetComponentsInChildren<Ghost>(true))
                    if (ghost != further && ghost.GetComponent<RobotRig>().IsOf(session)) _all.Add(ghost.gameObject);
                foreach (var shown in root.GetComponentsInChildren<TrackedObject>(true))
                    if (shown.Shows == RigPose.Held && shown.IsOf(session)) _all.Add(shown.gameObject);
            }
        }

        public void Set(bool shown)
        {
            foreach (var ghost in _all)
                if (ghost != null) ghost.SetActive(shown);
        }
    }
}
