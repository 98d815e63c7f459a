using Nowpose.Editor.Messages;

namespace Nowpose.Editor.Setup
{
    sealed class InternetAccessCheck : ProjectCheck
    {
        public InternetAccessCheck()
            : base(CheckTitles.InternetAccess, CheckReasons.InternetAccess, "Require internet access")
        { }

        public override CheckResult Look(IProjectSettings project) =>
            project.AsksForInternet ? Good(CheckResults.InternetAccess) : Missing("left to Unity");

        public override string Fix(IProjectSettings project)
        {
            project.AsksForInternet = true;
            return null;
        }
    }
}
