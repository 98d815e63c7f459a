using System.Collections.Generic;
using Nowpose.Anchoring;
using Nowpose.Unity.Status;

namespace Nowpose.Unity.Anchoring
{
    /// <summary>Selects the base to report among the base anchors of a session, which has one for each robot.</summary>
    sealed class SessionBases
    {
        readonly List<BaseAnchor> _found = new List<BaseAnchor>();

        /// <summary>
        /// Returns the active base anchor below a session whose pose is the least certain, the first of several. If none is active, returns the first one;
        /// null if there is none.
        /// </summary>
        public BaseAnchor WorstOf(MrilSession session)
        {
            session.GetComponentsInChildren(_found);
            BaseAnchor worst = null;
            foreach (var each in _found)
                if (worst == null || RankOf(each) > RankOf(worst)) worst = each;
            return worst != null ? worst : session.GetComponentInChildren<BaseAnchor>(true);
        }

        static int RankOf(BaseAnchor anchor)
        {
            switch (anchor.State)
            {
                case BaseAnchorState.Restored: return 2;
                case BaseAnchorState.Searching: return 3;
                case BaseAnchorState.Moved: return 4;
                case BaseAnchorState.Lost: return 5;
                default: return BaseTexts.IsWrong(anchor.Tracker) ? 1 : 0;
            }
        }
    }
}
